#include "app/ui/widgets/drag_number.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/typed_number.h"
#include "app/ui/widgets/widget_places.h"
#include "texplorer/base/translatable.h"

#include <fmt/core.h>
#include <imgui_internal.h> // whether a number is being typed

#include <cmath>

namespace texplorer::ui {
namespace {

std::string numberFormat(const Range& range) {
    const std::string unit = unitText(range);
    const bool isWord = !unit.empty() && !unit.starts_with('/') && !unit.starts_with("°");
    return fmt::format("%.{}f{}{}", decimalsOf(range), isWord ? " " : "", unit);
}

/// At the left end of the last widget, if the centred `number` leaves room.
void drawLetter(const char* letter, ImU32 tint, const std::string& number) {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetItemRectMin();
    const float x = low.x + em * 0.32F;
    const float middle = (low.x + ImGui::GetItemRectMax().x - ImGui::CalcTextSize(number.c_str()).x) / 2;
    if (x + ImGui::CalcTextSize(letter).x > middle)
        return;
    const ImVec2 at(x, low.y + ImGui::GetStyle().FramePadding.y);
    ImGui::GetWindowDrawList()->AddText(at, tint, letter);
    noteDrawn(fmt::format("letter:{}", letter), at, at);
}

} // namespace

int decimalsOf(const Range& range) {
    return range.step >= 0.5F ? 1 : range.step >= 0.01F ? 2 : 3;
}

std::string unitText(const Range& range) {
    return range.unit == "deg" ? "°" : tr(range.unit == "deg/s" ? std::string_view(N_("°/s")) : range.unit);
}

std::string secondsFormat() {
    return tr(Sentence("{0} s", ProperName{"%.2f"}));
}

void markDraggable() {
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float em = ImGui::GetFontSize();
    if (ImGui::GetIO().WantTextInput || high.x - low.x < em * 6)
        return;
    const ImU32 tint = hot ? color::text : ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.43F);
    const float y = (low.y + high.y) / 2;
    const float size = em * 0.2F;
    const float left = low.x + em * 0.7F;
    const float right = high.x - em * 0.7F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddTriangleFilled({left - size, y}, {left, y - size}, {left, y + size}, tint);
    draw.AddTriangleFilled({right + size, y}, {right, y + size}, {right, y - size}, tint);
}

bool dragFloat(const char* id, float& value, float step, float min, float max, const char* format) {
    const std::optional<bool> typed = typedNumber(id, value, min, max, format);
    return typed ? *typed
                 : ImGui::DragFloat(id, &value, step, min, max, format, ImGuiSliderFlags_AlwaysClamp);
}

bool dragInt(const char* id, int& value, float step, int min, int max, const char* format) {
    auto number = static_cast<float>(value);
    const std::optional<bool> typed =
        typedNumber(id, number, static_cast<float>(min), static_cast<float>(max), "%.0f");
    if (!typed)
        return ImGui::DragInt(id, &value, step, min, max, format, ImGuiSliderFlags_AlwaysClamp);
    value = *typed ? static_cast<int>(std::lround(number)) : value;
    return *typed;
}

bool dragNumber(const char* id, float& value, const Range& range, int component, const char* instead,
                const char* letter) {
    const std::string format =
        component >= 0 ? numberFormat({range.min, range.max, range.step, {}}) : numberFormat(range);
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID(id)); // at the left end, like the letter
    const bool changed = dragFloat(id, value, range.step, range.min, range.max,
                                   instead && !typing ? tr(instead) : format.c_str());
    markDraggable();
    if (component >= 0) {
        const ImVec2 low = ImGui::GetItemRectMin();
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, {low.x + ImGui::GetFontSize() * 0.2F, ImGui::GetItemRectMax().y}, componentColor(component),
            ImGui::GetStyle().FrameRounding, ImDrawFlags_RoundCornersLeft);
        if (letter && !typing)
            drawLetter(letter, componentColor(component), fmt::format("{:.{}f}", value, decimalsOf(range)));
    }
    return changed;
}

bool slideNumber(const char* id, float& value, const Range& range, float end) {
    // The number is drawn over the grab, which is faint enough to keep the number readable.
    ImVec4 grab = ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab);
    grab.w *= 0.4F;
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, grab);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, grab);
    const std::optional<bool> typed = typedNumber(id, value, range.min, end, "%.1f");
    const bool changed =
        typed ? *typed
              : ImGui::SliderFloat(id, &value, range.min, end, "%.1f",
                                   ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleColor(2);
    return changed;
}

void sealAfterItem(const Session& session) {
    if (ImGui::IsItemActivated() || ImGui::IsItemDeactivated())
        sealEdit(session);
}

} // namespace texplorer::ui
