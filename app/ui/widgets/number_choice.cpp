#include "app/ui/widgets/number_choice.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

/// Where a button has a dot, it is in its upper right corner.
void drawDot() {
    const ImVec2 corner(ImGui::GetItemRectMax().x, ImGui::GetItemRectMin().y);
    const float radius = ImGui::GetFontSize() * 0.16F;
    ImGui::GetWindowDrawList()->AddCircleFilled({corner.x - 2.2F * radius, corner.y + 2.2F * radius}, radius,
                                                color::t);
}

} // namespace

std::optional<int> numberChoice(const char* words, const char* shortWords, const char* name,
                                std::span<const NumberChoice> choices, int chosen) {
    const char* shown = tr(words);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(choices.size());
    const float wanted = ImGui::GetFrameHeight() * 1.3F;
    if (room < ImGui::CalcTextSize(shown).x + count * (wanted + gap) + gap)
        shown = tr(shortWords);
    float left = room - ImGui::CalcTextSize(shown).x - gap * (count + 1);
    const bool ownLine = left < count * ImGui::GetFontSize() * 1.2F;
    if (ownLine)
        left = room - gap * (count - 1);
    const float width = std::clamp(std::floor(left / count), 1.0F, wanted);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown);
    std::optional<int> pressed;
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) {
        const NumberChoice& choice = choices[static_cast<std::size_t>(i)];
        if (i > 0 || !ownLine)
            ImGui::SameLine(0, gap * (i == 0 ? 2.0F : 1.0F));
        const bool isChosen = i == chosen;
        if (isChosen)
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
        if (ImGui::Button(fmt::format("{}##{}", i, name).c_str(), {width, 0}))
            pressed = i;
        noteItem(fmt::format("{}:{}", name, i));
        if (isChosen)
            ImGui::PopStyleColor();
        if (choice.on)
            drawDot();
        helpTip(choice.tip);
    }
    return pressed;
}

} // namespace texplorer::ui
