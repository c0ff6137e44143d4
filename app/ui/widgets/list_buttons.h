#pragma once

#include "texplorer/scene/edit/edit.h"

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The edits of a list.
enum class ListEdit { Add, Up, Down, Remove };

/// The texts of the buttons, and the names of the edits in Undo.
struct ListWords {
    const char* name; ///< of the buttons in tests: "pass" for "add pass" and "pass up"
    const char* add;
    const char* up;
    const char* down;
    const char* remove;
    const char* added; ///< "Add pass"
    const char* reordered;
    const char* removed;

    [[nodiscard]] const char* nameOf(ListEdit edit) const {
        return edit == ListEdit::Add ? added : edit == ListEdit::Remove ? removed : reordered;
    }
};

/// What a button does to the element `index` of a list, "passes". Add inserts a copy after it.
[[nodiscard]] Edit editOf(ListEdit pressed, const std::string& list, std::size_t index);

/// +, ↑, ↓ and ✕ at the right end of a line, for the selected element of a list of `count`, which must have
/// `min` to `max`. Returns the pressed one, if any.
[[nodiscard]] std::optional<ListEdit> listButtons(const ListWords& words, std::size_t chosen,
                                                  std::size_t count, std::size_t min, std::size_t max);

/// ↑, ↓ and ✕ at the right end of an element's line; the name in tests is "path#up". Returns the pressed one,
/// if any.
[[nodiscard]] std::optional<ListEdit> elementButtons(const ListWords& words, const std::string& path,
                                                     std::size_t index, std::size_t count);

} // namespace texplorer::ui
