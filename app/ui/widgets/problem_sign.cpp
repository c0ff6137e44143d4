#include "app/ui/widgets/problem_sign.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/tip.h"
#include "app/ui/widgets/widget_places.h"

#include <fmt/core.h>

#include <cfloat>

namespace texplorer::ui {

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
    noteItem(path + "#problem");
    helpTip(problem.fixes.empty() ? sentenceOf(problem)
                                  : fmt::format("{}\n{}", sentenceOf(problem), "Click: show fixes"));
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowSizeConstraints({0, 0}, {em * 24, FLT_MAX});
    if (!ImGui::BeginPopup("problem"))
        return;
    ImGui::PushTextWrapPos(em * 22);
    text(sentenceOf(problem));
    ImGui::PopTextWrapPos();
    for (const Fix& fix : problem.fixes) {
        if (ImGui::Button(label(fix.label).c_str())) {
            applyFix(session, fix);
            ImGui::CloseCurrentPopup();
        }
        noteItem(fmt::format("{}#fix:{}", path, fix.label));
        helpTip(assignmentsOf(fix));
    }
    ImGui::EndPopup();
}

} // namespace texplorer::ui
