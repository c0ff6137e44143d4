#include "app/ui/widgets/hover_link.h"

namespace texplorer::ui {

void linkHover(const Session& session, std::string_view path) {
    if (path.empty())
        return;
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        session.out.hoveredParam = path;
        return;
    }
    if (session.window.hoveredParam != path)
        return;
    frameItem(ImGui::GetFontSize() * 0.1F, ImGui::GetColorU32(ImGuiCol_CheckMark),
              ImGui::GetStyle().FrameRounding);
}

void frameItem(float margin, ImU32 ink, float rounding, float width) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect({low.x - margin, low.y - margin}, {high.x + margin, high.y + margin},
                                        ink, rounding, 0, width);
}

} // namespace texplorer::ui
