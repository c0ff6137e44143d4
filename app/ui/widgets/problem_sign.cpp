#include "app/ui/model/findings.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_parts.h"

#include <cfloat>

namespace texplorer::ui {
namespace {

/// Leaves room for a sign; its upper left corner.
ImVec2 signPlace() {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({ImGui::GetFontSize() * 0.85F, ImGui::GetFrameHeight()});
    return {low.x, low.y + ImGui::GetStyle().FramePadding.y};
}

/// A triangle with an exclamation mark, as high as a control.
void warningSign() {
    const float em = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 low = signPlace();
    const float middle = low.x + em * 0.425F;
    draw.AddTriangleFilled({middle, low.y + em * 0.1F}, {low.x + em * 0.85F, low.y + em * 0.9F},
                           {low.x, low.y + em * 0.9F}, color::problem);
    draw.AddRectFilled({middle - em * 0.05F, low.y + em * 0.38F}, {middle + em * 0.05F, low.y + em * 0.64F},
                       color::ground);
    draw.AddRectFilled({middle - em * 0.05F, low.y + em * 0.7F}, {middle + em * 0.05F, low.y + em * 0.8F},
                       color::ground);
}

/// An i in a circle, for information that is not a warning.
void noteSign() {
    const float em = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 low = signPlace();
    const ImVec2 middle(low.x + em * 0.425F, low.y + em * 0.5F);
    draw.AddCircleFilled(middle, em * 0.4F, color::dim);
    const auto stroke = [&](float from, float to) {
        draw.AddRectFilled({middle.x - em * 0.05F, middle.y + em * from},
                           {middle.x + em * 0.05F, middle.y + em * to}, color::ground);
    };
    stroke(-0.26F, -0.14F);
    stroke(-0.06F, 0.24F);
}

} // namespace

void problemSign(const Session& session, const std::string& path, const Finding& problem) {
    const ImVec2 place = ImGui::GetCursorPos();
    if (problem.severity <= Severity::Warning)
        warningSign();
    else
        noteSign();
    const ImVec2 size = ImGui::GetItemRectSize();
    ImGui::SetCursorPos(place);
    if (ImGui::InvisibleButton("sign", size))
        ImGui::OpenPopup("problem");
    item(path + "#problem", problem.fixes.empty() ? shownSentence(problem.sentence)
                                                  : Sentence("{0}\n{1}", shownSentence(problem.sentence),
                                                             N_("Click: show fixes")));
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowSizeConstraints({0, 0}, {em * 24, FLT_MAX});
    if (!ImGui::BeginPopup("problem"))
        return;
    ImGui::PushTextWrapPos(em * 22);
    text(shownSentence(problem.sentence));
    ImGui::PopTextWrapPos();
    for (const Fix& fix : problem.fixes) {
        if (button(fix.label, path + "#fix:" + fix.label.english(), ProperName{assignmentsOf(fix)})) {
            applyFix(session, fix);
            ImGui::CloseCurrentPopup();
        }
    }
    ImGui::EndPopup();
}

} // namespace texplorer::ui
