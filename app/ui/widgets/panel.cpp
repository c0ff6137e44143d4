#include "app/ui/widgets/panel.h"

namespace texplorer::ui {
namespace {

void beginFixed(const char* name, const Rect& rect, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(lowOf(rect));
    ImGui::SetNextWindowSize(extentOf(rect));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr,
                 flags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
}

} // namespace

void beginPanel(const char* name, const Rect& rect, ImGuiWindowFlags flags) {
    beginFixed(name, rect, flags | ImGuiWindowFlags_NoBackground);
}

void beginBar(const char* name, const Rect& rect, ImGuiWindowFlags flags) {
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    beginFixed(name, rect, flags);
    ImGui::PopStyleColor();
}

ImVec4 panelGround() {
    return ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
}

} // namespace texplorer::ui
