#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Limits the bytes of a note: a longer one would have more letters, each with its halo, than a draw list of
/// Dear ImGui can hold.
inline constexpr std::size_t maxNoteBytes = 500;

/// A note over the view, for presentations.
struct ViewNote {
    glm::vec2 at{0.5F}; ///< its upper left corner, as a fraction of the picture area
    std::string text{};
};

/// The notes over the view of a document. They are not saved.
struct ViewNotes {
    std::vector<ViewNote> list;
    std::optional<std::size_t> chosen; ///< Delete removes it
    bool isEdited = false;             ///< the chosen one is a text field
    bool wantsKeyboard = false;        ///< the text field gets the keyboard in the next frame
};

void editNote(ViewNotes& notes, std::size_t index);
/// Adds an empty note, selected and being edited.
void addNote(ViewNotes& notes, glm::vec2 at);
/// Cuts a text that is too long for a note and ends it with "…".
void shortenNote(std::string& text);
void removeNote(ViewNotes& notes, std::size_t index);

} // namespace texplorer::ui
