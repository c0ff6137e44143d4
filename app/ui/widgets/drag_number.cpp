#include "app/ui/widgets/drag_number.h"

#include "app/ui/widgets/theme.h"

#include <fmt/core.h>
#include <imgui.h>

#include <string>

namespace texplorer::ui {
namespace {

std::string numberFormat(const Range& range) {
    const int decimals = range.step >= 0.5F ? 1 : range.step >= 0.01F ? 2 : 3;
    std::string format = fmt::format("%.{}f", decimals);
    if (range.unit == "deg")
        return format + "°";
    if (range.unit == "deg/s")
        return format + "°/s";
    if (range.unit.empty())
        return format;
    return format + (range.unit.starts_with('/') ? "" : " ") + std::string(range.unit);
}

} // namespace

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

bool dragNumber(const char* id, float& value, const Range& range, int component, const char* instead) {
    const std::string format =
        component >= 0 ? numberFormat({range.min, range.max, range.step, {}}) : numberFormat(range);
    const bool changed = ImGui::DragFloat(id, &value, range.step, range.min, range.max,
                                          instead ? instead : format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    markDraggable();
    if (component >= 0) {
        const ImVec2 low = ImGui::GetItemRectMin();
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, {low.x + ImGui::GetFontSize() * 0.2F, ImGui::GetItemRectMax().y}, componentColor(component),
            ImGui::GetStyle().FrameRounding, ImDrawFlags_RoundCornersLeft);
    }
    return changed;
}

} // namespace texplorer::ui
