#include "app/ui/window/notes.h"

#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/text_field.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/tip.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr float noteScale = 1.25F; ///< relative to the text around it, for a distant audience
constexpr float maxNoteWidth = 22; ///< in letters' heights, then it wraps
constexpr float minFieldWidth = 12;

/// Eight shifted copies below the letters form a halo that separates them from the background.
void haloedText(ImDrawList& draw, ImVec2 at, const std::string& words) {
    const std::array ways{ImVec2{1, 0},     ImVec2{-1, 0},     ImVec2{0, 1},      ImVec2{0, -1},
                          ImVec2{.7F, .7F}, ImVec2{-.7F, .7F}, ImVec2{.7F, -.7F}, ImVec2{-.7F, -.7F}};
    ImFont* font = ImGui::GetFont();
    const float size = ImGui::GetFontSize();
    const float halo = std::max(2.0F, size * 0.15F);
    const char* begin = words.c_str();
    const char* end = begin + words.size();
    for (const ImVec2& way : ways)
        draw.AddText(font, size, {at.x + way.x * halo, at.y + way.y * halo}, color::panel, begin, end);
    draw.AddText(font, size, at, color::text, begin, end);
}

/// Completely inside of the picture area, if it fits.
ImVec2 notePlace(const ViewNote& note, const Rect& canvas, ImVec2 size) {
    const auto within = [](float at, float from, float whole, float own) {
        return std::clamp(from + at * whole, from, std::max(from, from + whole - own));
    };
    const ImVec2 low = lowOf(canvas);
    const ImVec2 whole = extentOf(canvas);
    return {within(note.at.x, low.x, whole.x, size.x), within(note.at.y, low.y, whole.y, size.y)};
}

glm::vec2 shareOfCanvas(ImVec2 at, const Rect& canvas) {
    return {(at.x - static_cast<float>(canvas.x)) / static_cast<float>(std::max(1, canvas.width)),
            (at.y - static_cast<float>(canvas.y)) / static_cast<float>(std::max(1, canvas.height))};
}

/// In pixels: as wide as its words, at most as the pictures.
float fieldWidth(const ViewNote& note, const Rect& canvas, float em) {
    const float words = ImGui::CalcTextSize(note.text.c_str()).x * em / ImGui::GetFontSize() + 2 * em;
    return std::min(std::max(words, minFieldWidth * em), static_cast<float>(canvas.width));
}

/// Does nothing if an earlier request has removed the note.
void changeNote(const Session& session, std::size_t index, std::function<void(ViewNotes&)> make) {
    act(session, [index, make = std::move(make)](Session& changed) {
        if (index < changed.look.notes.list.size())
            make(changed.look.notes);
    });
}

/// The selected note as a text field. Enter and a click elsewhere end the edit, Escape restores the words; an
/// empty note is then removed.
void noteField(const Session& session, std::size_t index, float width) {
    const ViewNotes& notes = session.look.notes;
    ImGui::SetNextItemWidth(width);
    if (notes.wantsKeyboard) {
        ImGui::SetWindowFocus();
        focusNextWidget();
        changeNote(session, index, [](ViewNotes& changed) { changed.wantsKeyboard = false; });
    }
    std::string words = notes.list[index].text;
    textField("##words", words, ImGuiInputTextFlags_AutoSelectAll, N_("Text over the view"));
    shortenNote(words);
    noteItem("note:field");
    if (words != notes.list[index].text)
        changeNote(session, index, [index, words](ViewNotes& changed) { changed.list[index].text = words; });
    if (ImGui::IsItemDeactivated())
        changeNote(session, index, [](ViewNotes& changed) { changed.isEdited = false; });
}

/// Returns true if the pointer is on it.
bool noteButton(const Session& session, std::size_t index, const Rect& canvas, const std::string& lines,
                ImVec2 size) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + size.x, low.y + size.y);
    ImGui::InvisibleButton("note", size);
    noteItem(fmt::format("note:{}", index));
    const bool hovered = ImGui::IsItemHovered();
    helpTip("Drag: move. Double click: edit. Delete: remove.");
    if (hovered || ImGui::IsItemActive())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemActivated())
        changeNote(session, index, [index](ViewNotes& notes) { notes.chosen = index; });
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        const ImVec2 way = ImGui::GetIO().MouseDelta;
        const glm::vec2 at = glm::clamp(shareOfCanvas({low.x + way.x, low.y + way.y}, canvas), 0.0F, 1.0F);
        changeNote(session, index, [index, at](ViewNotes& notes) { notes.list[index].at = at; });
    }
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        changeNote(session, index, [index](ViewNotes& notes) { editNote(notes, index); });
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool chosen = session.look.notes.chosen == index;
    if (hovered || chosen)
        draw.AddRect(low, high, chosen ? color::accent : color::dim);
    const float pad = ImGui::GetFontSize() * 0.25F;
    haloedText(draw, {low.x + pad, low.y + pad / 2}, lines);
    return hovered;
}

/// Each note is a window, so that it is over the view and gets the pointer first. Returns true if the pointer
/// is on it.
bool drawNote(const Session& session, std::size_t index, const Rect& canvas) {
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNavFocus;
    const ViewNotes& notes = session.look.notes;
    const ViewNote& note = notes.list[index];
    const bool isEdited = notes.isEdited && notes.chosen == index;
    const float em = ImGui::GetFontSize() * noteScale;
    ImVec2 size(fieldWidth(note, canvas, em), em * 1.5F);
    std::string lines;
    if (!isEdited) {
        lines = wrappedLines(note.text, maxNoteWidth * em / noteScale);
        size = ImGui::CalcTextSize(lines.c_str());
        size = {size.x * noteScale + em, size.y * noteScale + em * 0.25F};
    }
    ImGui::SetNextWindowPos(notePlace(note, canvas, size));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin(fmt::format("###note{}", index).c_str(), nullptr, flags);
    ImGui::SetWindowFontScale(noteScale);
    bool hovered = false;
    if (isEdited)
        noteField(session, index, size.x);
    else
        hovered = noteButton(session, index, canvas, lines, size);
    ImGui::End();
    ImGui::PopStyleVar(2);
    return hovered || isEdited;
}

void removeChosenIfEmpty(ViewNotes& notes) {
    if (!notes.isEdited && notes.chosen && notes.list[*notes.chosen].text.empty())
        removeNote(notes, *notes.chosen);
}

} // namespace

void addNoteAtPointer(Session& session, const Layout& layout) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (layout.canvas.contains(mouse.x, mouse.y))
        addNote(session.look.notes, shareOfCanvas(mouse, layout.canvas));
}

void addNoteInTheMiddle(Session& session) {
    const auto before = static_cast<float>(session.look.notes.list.size() % 10);
    addNote(session.look.notes, {0.4F, 0.3F + 0.06F * before});
}

void clearNotes(Session& session) {
    session.look.notes = {};
}

void drawNotes(const Session& session, const Layout& layout) {
    const ViewNotes& notes = session.look.notes;
    if (notes.list.empty() || layout.canvas.isEmpty())
        return;
    std::optional<std::size_t> pointed;
    for (std::size_t i = 0; i < notes.list.size(); ++i) {
        if (drawNote(session, i, layout.canvas))
            pointed = i;
    }
    if (!pointed && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        act(session, [](Session& changed) { changed.look.notes.chosen.reset(); });
    const bool isFree = !notes.isEdited && session.asking.dialog == Dialog::None && !session.out.keyTaken &&
                        !ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive();
    const std::optional<std::size_t> removed = pointed ? pointed : notes.chosen;
    if (removed && isFree && isKeyPressed(key::del, false)) {
        session.out.keyTaken = true;
        changeNote(session, *removed, [index = *removed](ViewNotes& changed) { removeNote(changed, index); });
    }
    if (notes.chosen) // after the other changes, which may end the edit or select another note
        act(session, [](Session& changed) { removeChosenIfEmpty(changed.look.notes); });
}

} // namespace texplorer::ui
