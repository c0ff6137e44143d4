#include "app/ui/language/translate.h"
#include "app/ui/lesson/lesson_tab.h"
#include "app/ui/model/lesson_key_edits.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace texplorer::ui {
namespace {

std::string capText(std::string_view name) {
    return tr(std::string(lesson::signOfKey(name)));
}

float capHeight() {
    return std::floor(ImGui::GetFontSize() * 1.4F);
}

float capWidth(const std::string& sign) {
    const float em = ImGui::GetFontSize();
    return std::max(ImGui::CalcTextSize(sign.c_str()).x + em * 0.7F, em * 1.5F);
}

/// A key of the lesson as a button. A click acts like the key.
void keyCap(const Session& session, const LessonRun& run, std::size_t number) {
    const float em = ImGui::GetFontSize();
    const lesson::LessonKey& each = run.lesson.keys[number];
    const std::string sign = capText(each.key);
    const bool usable = isUsable(run, number);
    const ImVec2 size(capWidth(sign), capHeight());
    ImGui::PushID(static_cast<int>(number));
    ImGui::BeginDisabled(!usable);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("cap", size))
        pressLessonKeys(session, std::array{KeyPress{number}});
    noteItem("lesson key:" + each.key);
    if (ImGui::IsItemDeactivated())
        releaseLessonKey(session);
    const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
    ImGui::EndDisabled();
    helpTip(usable ? "A key of this lesson. Press it or click here. It overrides the window's shortcut."
                   : N_("A key of this lesson. It has no effect on the scene of this step."));
    const bool held = usable && run.heldKey == number;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 high(low.x + size.x, low.y + size.y);
    const ImU32 edge = held ? color::chosen : usable ? color::outline : color::faint;
    draw.AddRectFilled(low, high,
                       ImGui::GetColorU32(held || hovered ? ImGuiCol_ButtonHovered : ImGuiCol_Button),
                       em * 0.25F);
    draw.AddRect(low, high, edge, em * 0.25F);
    draw.AddLine({low.x + em * 0.2F, high.y - 1}, {high.x - em * 0.2F, high.y - 1}, edge, em * 0.12F);
    draw.AddText({low.x + (size.x - ImGui::CalcTextSize(sign.c_str()).x) / 2, low.y + (size.y - em) / 2},
                 usable ? color::text : color::faint, sign.c_str());
    ImGui::PopID();
}

/// Two keys that increase and decrease the same number are described together.
bool isWithNext(const std::vector<lesson::LessonKey>& keys, std::size_t number) {
    if (number + 1 >= keys.size() || keys[number].label != keys[number + 1].label)
        return false;
    const auto* one = std::get_if<lesson::Addition>(&keys[number].effect);
    const auto* other = std::get_if<lesson::Addition>(&keys[number + 1].effect);
    return one && other && one->path == other->path && one->component == other->component;
}

/// The action of a key and its current effect, in the window's language: in one line, or in two if there is
/// no room.
void drawEffect(const std::string& words, const std::string& state, bool usable, float room) {
    const float em = ImGui::GetFontSize();
    const float wordsWidth = ImGui::CalcTextSize(words.c_str()).x + em * 0.35F;
    const float stateWidth = ImGui::CalcTextSize(state.c_str()).x;
    const bool below = wordsWidth + stateWidth > room;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 at(low.x, low.y + (capHeight() - em) / 2);
    const float width = below ? std::max(wordsWidth, stateWidth) : wordsWidth + stateWidth;
    ImGui::Dummy({std::min(width, room), capHeight() + (below ? em * 1.2F : 0)});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(at, usable ? color::dim : color::faint, fitted(ProperName{words}, room).c_str());
    draw.AddText(below ? ImVec2(at.x, at.y + em * 1.2F) : ImVec2(at.x + wordsWidth, at.y),
                 usable ? color::text : color::faint, fitted(ProperName{state}, room).c_str());
}

} // namespace

void drawLessonKeys(const Session& session, const LessonRun& run) {
    const std::vector<lesson::LessonKey>& keys = run.lesson.keys;
    if (keys.empty())
        return;
    const float em = ImGui::GetFontSize();
    const float gap = em * 0.35F;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t first = 0; first < keys.size();) {
        std::size_t last = first;
        float width = capWidth(capText(keys[first].key));
        while (isWithNext(keys, last)) {
            ++last;
            width += em * 0.15F + capWidth(capText(keys[last].key));
        }
        const std::string words = run.text(keys[first].label);
        const bool usable = isUsable(run, first);
        const std::string state = usable ? stateOfKey(session, run, first) : std::string("–");
        width += 2 * gap + ImGui::CalcTextSize(words.c_str()).x + ImGui::CalcTextSize(state.c_str()).x;
        if (first > 0)
            sameLineFor(width, em);
        for (std::size_t key = first; key <= last; ++key) {
            keyCap(session, run, key);
            ImGui::SameLine(0, key < last ? em * 0.15F : gap);
        }
        drawEffect(words, state, usable, right - ImGui::GetCursorScreenPos().x);
        if (usable)
            noteItem(fmt::format("lesson key:{}={}", keys[first].key, state));
        first = last + 1;
    }
    ImGui::Dummy({0, em * 0.3F});
}

} // namespace texplorer::ui
