#include "app/ui/details/explain_list.h"

#include "app/ui/details/step_rows.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

using reference::Step;

bool differsFrom(const reference::FragmentSteps* other, const Step& step) {
    if (!other)
        return false;
    const auto same = std::ranges::find_if(
        other->steps, [&](const Step& each) { return each.kind == step.kind && each.unit == step.unit; });
    return same == other->steps.end() || same->summary != step.summary;
}

/// A bar, so that differences are not marked only by a colour.
void differenceMark() {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + em * 0.25F, low.y + em}, color::changed);
    ImGui::Dummy({em * 0.25F, em});
}

void drawListedStep(const Step& step, bool openAtFirst, bool severalUnits, bool differs) {
    const std::string title =
        step.unit < 0 || !severalUnits ? step.title : fmt::format("{}, unit {}", step.title, step.unit);
    ImGui::PushID(static_cast<int>(step.kind) * 8 + step.unit);
    // The texels are the most important.
    ImGui::SetNextItemOpen(openAtFirst && step.kind == reference::StepKind::Texels, ImGuiCond_FirstUseEver);
    const bool hasRows = !step.rows.empty();
    const bool open =
        ImGui::TreeNodeEx("step", ImGuiTreeNodeFlags_SpanAvailWidth | (hasRows ? 0 : ImGuiTreeNodeFlags_Leaf),
                          "%s", tr(title).c_str());
    noteItem("explain:" + title);
    ImGui::SameLine();
    if (step.swatch) {
        swatch(*step.swatch);
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    const bool idle = step.kind == reference::StepKind::IdleUnit;
    const ImU32 usual = idle ? color::problem : color::dim;
    if (differs) {
        differenceMark();
        noteItem("explain:differs " + title);
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    hangingText(step.summary, differs ? ImU32(color::changed) : usual);
    noteItem("explain:summary of " + title);
    if (open) {
        ImGui::TreePop(); // before the rows: they need the width
        drawRows(step.rows);
        noteItem("explain:rows of " + title);
    }
    ImGui::PopID();
}

void drawFragment(const reference::FragmentSteps& fragment, const reference::FragmentExplanation& explained,
                  std::size_t index, bool seen, const reference::FragmentSteps* other) {
    ImGui::PushID(seen ? -1 : static_cast<int>(index));
    ImGui::SetNextItemOpen(seen, ImGuiCond_FirstUseEver);
    const std::string title = titleOf(fragment);
    ImGui::PushStyleColor(ImGuiCol_Text, fragment.drawn ? color::text : color::dim);
    const float room = ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX() - ImGui::GetCursorPosX() -
                       ImGui::GetTreeNodeToLabelSpacing() - ImGui::GetFontSize() * 0.5F;
    const bool open = ImGui::CollapsingHeader((fitted(title, room) + "###fragment").c_str());
    if (fitted(title, room) != tr(title))
        helpTip(title);
    ImGui::PopStyleColor();
    noteItem(fmt::format("explain:fragment {}", index));
    for (const Step& step : fragment.steps) {
        if (open)
            drawListedStep(step, seen, explained.units.size() + explained.idle.size() > 1,
                           seen && differsFrom(other, step));
    }
    ImGui::PopID();
}

} // namespace

std::string titleOf(const reference::FragmentSteps& fragment) {
    return fragment.drawn ? fragment.title : fmt::format("{}: {}", fragment.title, fragment.outcome);
}

void drawFragmentList(const reference::Explanation& explanation,
                      const std::vector<reference::FragmentSteps>& fragments,
                      const reference::FragmentSteps* other) {
    const reference::FragmentExplanation* seen = explanation.seen();
    for (const bool wanted : {true, false}) {
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            if ((seen == &explanation.fragments[i]) == wanted)
                drawFragment(fragments[i], explanation.fragments[i], i, wanted, other);
        }
    }
}

} // namespace texplorer::ui
