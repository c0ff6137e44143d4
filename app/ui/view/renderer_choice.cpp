#include "app/ui/view/renderer_choice.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

namespace texplorer::ui {

namespace {

constexpr const char* compareHelp = "Two renderers across one picture, or all of them with the difference.";
constexpr const char* nothingToCompare = "There is one renderer here, and nothing to compare it with.";

bool choice(const std::string& name, bool chosen, bool offered, std::string_view help) {
    ImGui::BeginDisabled(!offered);
    ImGui::PushStyleColor(ImGuiCol_Button,
                          chosen ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : IM_COL32(0, 0, 0, 0));
    const bool pressed = ImGui::Button(label(name).c_str());
    ImGui::PopStyleColor();
    ImGui::EndDisabled();
    noteItem("renderer:" + name);
    helpTip(help);
    return pressed;
}

std::string keyHelp(int key) {
    return fmt::format("Key {}", key);
}

} // namespace

std::string helpOf(const ViewSettings& settings, const EnumRow& renderer) {
    const std::string& reason = settings.offered.whyNot(static_cast<RendererKind>(renderer.value));
    return reason.empty() ? std::string(renderer.help)
                          : fmt::format("{}\n{}", renderer.help, fmt::format("Not available: {}.", reason));
}

void drawRendererChoice(ViewSettings& settings, float available) {
    const std::span<const EnumRow> rows = EnumTable<RendererKind>::rows;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    const float before = ImGui::GetFontSize();
    const char* compare = "Compare";
    float needed = before + buttonWidth(compare);
    for (const EnumRow& row : rows)
        needed += buttonWidth(std::string(row.label).c_str()) + gap;
    if (needed > available)
        return; // the View menu has them all
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + before);
    ImGui::SetCursorPosY((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) / 2);
    int key = 0;
    for (const EnumRow& row : rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen = !comparesRenderers(settings) && settings.renderer == renderer;
        const std::string help = fmt::format("{}\n{}", helpOf(settings, row), keyHelp(++key));
        if (choice(std::string(row.label), chosen, settings.offered.has(renderer), help))
            showOne(settings, renderer);
        ImGui::SameLine(0, gap);
    }
    if (choice(compare, comparesRenderers(settings), canCompare(settings),
               fmt::format("{}\n{}", canCompare(settings) ? compareHelp : nothingToCompare, keyHelp(++key))))
        showComparison(settings);
    ImGui::SameLine(0, gap);
}

} // namespace texplorer::ui
