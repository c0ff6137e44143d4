#pragma once

#include "app/ui/language/translate.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/tip.h"
#include "app/ui/widgets/widget_places.h"

#include <imgui.h>

namespace texplorer::ui {

/// The width of a text in English, in the window's language.
[[nodiscard]] inline float textWidth(const Sentence& words) {
    return ImGui::CalcTextSize(tr(words).c_str()).x;
}

/// The width of a button with these words, in pixels: to check before drawing whether a row fits.
[[nodiscard]] inline float buttonWidth(const Sentence& words) {
    return textWidth(words) + 2 * ImGui::GetStyle().FramePadding.x;
}

/// The width for the text in a list with an arrow.
[[nodiscard]] inline float listRoom(float width) {
    return width - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
}

/// A button with its text and its help in English, which a disabled one shows as well, and its name in tests.
inline bool button(const Sentence& words, std::string_view name, const Sentence& help, bool enabled = true,
                   float width = 0) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label(words).c_str(), {width, 0});
    noteItem(name);
    ImGui::EndDisabled();
    helpTip(help);
    return pressed;
}

/// A button as high as its text, or, with large controls, as any other one.
inline bool smallButton(const char* words) {
    return targetHeight() > 0 ? ImGui::Button(words) : ImGui::SmallButton(words);
}

/// Flags of a tree's node: with large controls, it is as high as a button.
inline ImGuiTreeNodeFlags nodeHeight() {
    return targetHeight() > 0 ? ImGuiTreeNodeFlags_FramePadding : ImGuiTreeNodeFlags_None;
}

/// A button that stands out while it is marked; a flat one has no ground otherwise.
inline bool markedButton(const char* words, bool marked, ImVec2 size = {0, 0}, bool flat = false) {
    const ImU32 ground = flat ? 0 : ImGui::GetColorU32(ImGuiCol_Button);
    ImGui::PushStyleColor(ImGuiCol_Button, marked ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : ground);
    const bool pressed = ImGui::Button(words, size);
    ImGui::PopStyleColor();
    return pressed;
}
inline bool flatButton(const char* words, bool marked = false, ImVec2 size = {0, 0}) {
    return markedButton(words, marked, size, true);
}

/// Calls `item`, which draws an item that later ones may cover and take clicks from; returns its result. Dear
/// ImGui must be told before the item since 1.89.7, and after it in earlier versions.
template<typename Item>
bool overlappedItem(Item item) {
#if IMGUI_VERSION_NUM >= 18970
    ImGui::SetNextItemAllowOverlap();
    return item();
#else
    const bool result = item();
    ImGui::SetItemAllowOverlap();
    return result;
#endif
}

} // namespace texplorer::ui
