#include "app/ui/window/dialog_button.h"

#include "app/ui/language/translate.h"

#include <imgui.h>

#include <algorithm>

namespace texplorer::ui {

float dialogButtonWidth(const char* name) {
    const float em = ImGui::GetFontSize();
    return std::max(em * 6.5F, ImGui::CalcTextSize(tr(name)).x + em * 1.5F);
}

bool dialogButton(const char* name) {
    return ImGui::Button(label(name), {dialogButtonWidth(name), 0});
}

} // namespace texplorer::ui
