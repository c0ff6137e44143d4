#include "app/ui/widgets/popups.h"

#include "app/ui/widgets/theme.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

bool spaced(bool open) {
    if (open)
        beginEntries();
    return open;
}

} // namespace

void beginEntries() { // an entry reaches half of the spacing above and below its text
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {spacing.x, std::max(spacing.y, targetHeight() - ImGui::GetFontSize())});
}

void endEntries() {
    ImGui::PopStyleVar();
}

bool beginMenu(const char* label) {
    return spaced(ImGui::BeginMenu(label));
}

bool beginCombo(const char* name, const char* shown, ImGuiComboFlags flags) {
    return spaced(ImGui::BeginCombo(name, shown, flags));
}

bool beginPopup(const char* name) {
    return spaced(ImGui::BeginPopup(name));
}

bool beginPopupContextItem(const char* name) {
    return spaced(ImGui::BeginPopupContextItem(name));
}

void endMenu() {
    endEntries();
    ImGui::EndMenu();
}

void endCombo() {
    endEntries();
    ImGui::EndCombo();
}

void endPopup() {
    endEntries();
    ImGui::EndPopup();
}

} // namespace texplorer::ui
