#include "app/ui/model/preview.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/segments.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

constexpr std::array anisotropySteps{1, 2, 4, 8, 16};
constexpr float minSliderWidth = 2.8F; ///< next to the buttons, in letters' heights

/// A button for a degree of anisotropy, with a preview of its picture.
void offerAnisotropy(const Session& session, const ParamRow& row, const std::string& path, int step,
                     bool isChosen) {
    const std::string assignment = fmt::format("{}={}", path, step);
    item(assignment, step == 1
                         ? N_("One sample a pixel: no anisotropic filter")
                         : Sentence("Up to {0} samples along the longer side of a pixel's footprint", step));
    if (ImGui::IsItemHovered() && !isChosen)
        preview(session, assignment, Sentence("{0}: {1}", row.label, step),
                [&](Scene& scene) { (void)setParam(scene, path, std::to_string(step)); });
}

void anisotropyButtons(const Session& session, const Owner& owner, const ParamRow& row,
                       std::span<const Segment> segments, const SegmentPlan& plan, bool isIdle) {
    const auto value = std::get<float>(row.read(owner.values));
    const auto chosen = indexIn(anisotropySteps, value, [](int step) { return static_cast<float>(step); });
    ImGui::PushID("anisotropy");
    ImGui::PushStyleColor(ImGuiCol_Text, isIdle ? color::dim : color::text);
    const auto pressed = drawSegments(segments, plan, chosen, [&](std::size_t i) {
        offerAnisotropy(session, row, owner.pathOf(row), anisotropySteps.at(i), i == chosen);
    });
    ImGui::PopStyleColor();
    ImGui::PopID();
    if (!pressed || pressed == chosen)
        return;
    sealEdit(session);
    assignParam(session, owner, row, static_cast<float>(anisotropySteps.at(*pressed)));
    sealEdit(session);
}

} // namespace

float maxAnisotropyOf(float driver, const ParamRow& row) {
    return driver > row.range.min ? std::min(driver, row.range.max) : row.range.max;
}

void anisotropyLine(const Session& session, const Owner& texture, const ParamRow& row) {
    const bool isIdle = idleReasonOf(session.document.findings, texture.pathOf(row)) != nullptr;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    labelText(N_("Anisotropy"), isIdle ? color::dim : color::text);
    helpTip(row.help);
    ImGui::SameLine();
    const std::vector<Segment> segments =
        segmentsOf(anisotropySteps, [](int step) { return std::to_string(step); });
    // The slider takes half of the room, because positions on it are hard to hit, or else the rest next to
    // the buttons.
    const float room = ImGui::GetContentRegionAvail().x;
    std::optional<SegmentPlan> plan = planSegments(segments, room / 2 - gap, 1);
    if (!plan)
        plan = planSegments(segments, room - ImGui::GetFontSize() * minSliderWidth - gap, 1);
    if (plan) {
        anisotropyButtons(session, texture, row, segments, *plan, isIdle);
        ImGui::SameLine(0, gap);
    }
    paramSlider(session, texture, row, ImGui::GetContentRegionAvail().x,
                maxAnisotropyOf(session.document.diagnosis.driver.maxAnisotropy, row));
}

} // namespace texplorer::ui
