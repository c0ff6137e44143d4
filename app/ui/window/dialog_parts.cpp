#include "app/ui/window/dialog_parts.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/tip.h"
#include "app/ui/widgets/widget_places.h"

#include <imgui.h>

#include <algorithm>

namespace texplorer::ui {

bool beginModal(const Sentence& title, ImVec2 size) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const std::string shown = label(title);
    const bool fits = size.x == 0; // its content
    if (!ImGui::IsPopupOpen(shown.c_str()))
        ImGui::OpenPopup(shown.c_str());
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    if (fits)
        ImGui::SetNextWindowSizeConstraints({0, 0}, {display.x * 0.96F, display.y * 0.94F});
    else
        ImGui::SetNextWindowSize(size);
    return ImGui::BeginPopupModal(shown.c_str(), nullptr,
                                  (fits ? ImGuiWindowFlags_AlwaysAutoResize : ImGuiWindowFlags_NoResize) |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
}

void lineName(const char* words) {
    constexpr float nameColumn = 9; // in heights of a letter
    labelText(words, color::dim);
    ImGui::SameLine(ImGui::GetFontSize() * nameColumn);
}

float dialogButtonWidth(const char* words) {
    const float em = ImGui::GetFontSize();
    return std::max(em * 6.5F, ImGui::CalcTextSize(tr(words)).x + em * 1.5F);
}

bool dialogButton(const char* words, std::string_view name) {
    const bool pressed = ImGui::Button(label(words), {dialogButtonWidth(words), 0});
    noteItem(name);
    return pressed;
}

bool closeButton(std::string_view name) {
    return dialogButton(N_("Close"), name) || isKeyPressed(key::escape, false) ||
           isKeyPressed(key::enter, false);
}

void closeDialog(const Session& session) {
    act(session, [](Session& changed) { changed.asking.dialog = Dialog::None; });
    ImGui::CloseCurrentPopup();
}

void endWithAnswers(const Session& session, const std::vector<DialogAnswer>& answers) {
    const DialogAnswer* given = nullptr;
    for (const DialogAnswer& each : answers) {
        if (&each != &answers.front())
            ImGui::SameLine();
        ImGui::BeginDisabled(!each.enabled);
        if (dialogButton(each.words, each.name) ||
            (each.enabled && each.key != 0 && isKeyPressed(each.key, false)))
            given = &each;
        ImGui::EndDisabled();
        if (*each.help != '\0')
            helpTip(each.help);
    }
    if (given) {
        closeDialog(session);
        act(session, given->action);
    }
    ImGui::EndPopup();
}

} // namespace texplorer::ui
