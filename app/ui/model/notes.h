#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Bytes of a note: longer ones would have more letters, each with its halo, than one list of Dear ImGui's
/// takes.
inline constexpr std::size_t longestNote = 500;

/// Words that somebody who presents puts over the view.
struct ViewNote {
    glm::vec2 at{0.5F}; ///< its upper left corner, as a share of the pictures' room from there
    std::string text{};
};

/// They belong to the window, not to the scene, and end with it.
struct ViewNotes {
    std::vector<ViewNote> list;
    std::optional<std::size_t> chosen; ///< Delete removes it
    bool isEdited = false;             ///< the chosen one is a text field
    bool wantsKeyboard = false;        ///< which gets the keyboard with the next frame
};

void editNote(ViewNotes& notes, std::size_t index);
/// A new one that waits for its words, chosen and edited.
void addNote(ViewNotes& notes, glm::vec2 at);
/// A text that is longer than a note may be ends with "…".
void shortenNote(std::string& text);
void removeNote(ViewNotes& notes, std::size_t index);

} // namespace texplorer::ui
