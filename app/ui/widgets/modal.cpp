#include "app/ui/widgets/modal.h"

#include "app/ui/language/translate.h"

#include <imgui.h>

namespace texplorer::ui {

bool beginModal(const char* title) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const char* shown = label(title);
    if (!ImGui::IsPopupOpen(shown))
        ImGui::OpenPopup(shown);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {display.x * 0.96F, display.y * 0.94F});
    return ImGui::BeginPopupModal(shown, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings);
}

} // namespace texplorer::ui
