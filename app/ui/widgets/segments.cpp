#include "app/ui/widgets/segments.h"

#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/wrapped_text.h"

#include <cmath>
#include <numeric>

namespace texplorer::ui {

namespace {

float segmentPadding() {
    return std::floor(ImGui::GetFontSize() * 0.3F);
}

float minWidth(const Segment& segment) {
    return std::max(std::ceil(textWidth(segment.text)) + 2 * segmentPadding(), targetWidth());
}

float sumOf(const std::vector<float>& widths) {
    return std::accumulate(widths.begin(), widths.end(), 0.0F) +
           segmentGap() * static_cast<float>(widths.empty() ? 0 : widths.size() - 1);
}

/// The rest of a line is distributed equally over its buttons.
void stretch(std::vector<float>& widths, float room) {
    const float more = std::floor((room - sumOf(widths)) / static_cast<float>(widths.size()));
    for (float& width : widths)
        width += more;
    widths.back() += room - sumOf(widths);
}

/// `perLine` buttons in each line, in aligned columns if that fits and all lines are full.
std::optional<SegmentPlan> planLines(std::span<const Segment> segments, float width, std::size_t perLine) {
    SegmentPlan plan;
    std::vector<float> columns(perLine);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (i % perLine == 0)
            plan.lines.push_back({});
        plan.lines.back().widths.push_back(minWidth(segments[i]));
        columns[i % perLine] = std::max(columns[i % perLine], minWidth(segments[i]));
    }
    const bool aligned = segments.size() % perLine == 0 && sumOf(columns) <= width;
    for (SegmentPlan::Line& line : plan.lines) {
        if (aligned)
            line.widths = columns;
        if (sumOf(line.widths) > width)
            return std::nullopt;
        stretch(line.widths, width);
    }
    return plan;
}

/// One line per group, all buttons with the same width.
std::optional<SegmentPlan> planGroups(std::span<const Segment> segments, float width) {
    SegmentPlan plan;
    float widest = 0;
    std::size_t most = 0;
    for (const Segment& segment : segments) {
        if (plan.lines.empty() || plan.lines.back().group != segment.group)
            plan.lines.push_back({segment.group, {}});
        plan.lines.back().widths.push_back(0);
        most = std::max(most, plan.lines.back().widths.size());
        widest = std::max(widest, minWidth(segment));
        plan.names = std::max(plan.names, std::ceil(textWidth(segment.group)) + ImGui::GetFontSize() * 0.6F);
    }
    const float each = std::floor((width - plan.names - segmentGap() * static_cast<float>(most - 1)) /
                                  static_cast<float>(most));
    if (each < widest)
        return std::nullopt;
    for (SegmentPlan::Line& line : plan.lines)
        std::ranges::fill(line.widths, each);
    return plan;
}

} // namespace

float segmentGap() {
    return std::max(1.0F, std::floor(ImGui::GetFontSize() / 12));
}

std::optional<SegmentPlan> planSegments(std::span<const Segment> segments, float width,
                                        std::size_t maxLines) {
    if (segments.empty())
        return std::nullopt;
    if (!segments.front().group.empty()) {
        std::optional<SegmentPlan> plan = planGroups(segments, width);
        return plan && plan->lines.size() <= maxLines ? plan : std::nullopt;
    }
    for (std::size_t lines = 1; lines <= std::min(maxLines, segments.size()); ++lines) {
        const std::size_t perLine = (segments.size() + lines - 1) / lines;
        if (std::optional<SegmentPlan> plan = planLines(segments, width, perLine))
            return plan;
    }
    return std::nullopt;
}

std::optional<std::size_t> drawSegments(std::span<const Segment> segments, const SegmentPlan& plan,
                                        std::optional<std::size_t> chosen,
                                        const std::function<void(std::size_t)>& after,
                                        std::optional<ImU32> chosenInk) {
    const float gap = segmentGap();
    std::optional<std::size_t> pressed;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {segmentPadding(), ImGui::GetStyle().FramePadding.y});
    ImGui::BeginGroup();
    const float left = ImGui::GetCursorPosX();
    std::size_t number = 0;
    for (const SegmentPlan::Line& line : plan.lines) {
        if (plan.names > 0) {
            ImGui::AlignTextToFramePadding();
            text(line.group);
            ImGui::SameLine();
            ImGui::SetCursorPosX(left + plan.names);
        }
        for (std::size_t i = 0; i < line.widths.size(); ++i, ++number) {
            if (i > 0)
                ImGui::SameLine();
            const bool isChosen = chosen == number;
            ImGui::PushID(static_cast<int>(number));
            const bool isInked = isChosen && chosenInk;
            ImGui::PushStyleColor(ImGuiCol_Text, isInked ? ImGui::ColorConvertU32ToFloat4(*chosenInk)
                                                         : ImGui::GetStyleColorVec4(ImGuiCol_Text));
            if (markedButton(label(segments[number].text).c_str(), isChosen, {line.widths[i], 0}))
                pressed = number;
            ImGui::PopStyleColor();
            ImGui::PopID();
            if (isChosen) { // not only by its background
                const ImVec2 low = ImGui::GetItemRectMin();
                const ImVec2 high = ImGui::GetItemRectMax();
                ImGui::GetWindowDrawList()->AddRectFilled({low.x + gap, high.y - 2 * gap},
                                                          {high.x - gap, high.y},
                                                          ImGui::GetColorU32(ImGuiCol_CheckMark), gap);
            }
            after(number);
        }
    }
    ImGui::EndGroup();
    ImGui::PopStyleVar(2);
    return pressed;
}

std::optional<std::size_t> drawSegments(std::span<const Segment> segments, float width,
                                        std::optional<std::size_t> chosen,
                                        const std::function<void(std::size_t)>& after) {
    const auto plan = planSegments(segments, width, segments.size());
    return plan ? drawSegments(segments, *plan, chosen, after) : std::nullopt;
}

} // namespace texplorer::ui
