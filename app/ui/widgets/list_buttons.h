#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// What one does with an element of a list.
enum class ListEdit { Add, Up, Down, Remove };

/// How the buttons explain themselves, and what tests call them: "add pass", "pass up".
struct ListWords {
    const char* name; ///< "pass"
    const char* add;
    const char* up;
    const char* down;
    const char* remove;
};

/// +, ↑, ↓ and ✕ at the right end of a line, for the chosen element of a list of `count`, of which there must
/// be `least` to `most`. What was pressed, if anything.
[[nodiscard]] std::optional<ListEdit> listButtons(const ListWords& words, std::size_t chosen,
                                                  std::size_t count, std::size_t least, std::size_t most);

/// ↑, ↓ and ✕ at the right end of the line of one element; "path#up" is what tests call them. What was
/// pressed, if anything.
[[nodiscard]] std::optional<ListEdit> elementButtons(const ListWords& words, const std::string& path,
                                                     std::size_t index, std::size_t count);

} // namespace texplorer::ui
