#include "app/ui/state/notes.h"

#include <algorithm>
#include <string_view>

namespace texplorer::ui {

void editNote(ViewNotes& notes, std::size_t index) {
    notes.chosen = index;
    notes.isEdited = true;
    notes.wantsKeyboard = true;
}

void addNote(ViewNotes& notes, glm::vec2 at) {
    std::erase_if(notes.list, [](const ViewNote& each) { return each.text.empty(); }); // without text
    notes.list.push_back({{std::clamp(at.x, 0.0F, 1.0F), std::clamp(at.y, 0.0F, 1.0F)}});
    editNote(notes, notes.list.size() - 1);
}

void shortenNote(std::string& text) {
    if (text.size() <= maxNoteBytes)
        return;
    constexpr std::string_view dots = "…";
    std::size_t end = maxNoteBytes - dots.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80) // within a letter of UTF-8
        --end;
    text.replace(end, std::string::npos, dots);
}

void removeNote(ViewNotes& notes, std::size_t index) {
    if (index >= notes.list.size())
        return;
    notes.list.erase(notes.list.begin() + static_cast<std::ptrdiff_t>(index));
    notes.chosen.reset();
    notes.isEdited = false;
}

} // namespace texplorer::ui
