#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// A button of a choice, all of which are in sight at once.
struct Segment {
    std::string text;            ///< in English
    std::string_view group = {}; ///< those of a group have a line of their own, which begins with its name
};

/// How the buttons of a choice lie in a width, in pixels.
struct SegmentPlan {
    struct Line {
        std::string_view group;
        std::vector<float> widths; ///< of its buttons
    };
    std::vector<Line> lines;
    float names = 0; ///< what the groups' names take at the left
};

/// Between two buttons, and between two lines of them.
[[nodiscard]] float segmentGap();

/// The plan with the fewest lines in which no text is cut short; nothing: there is none with so few.
[[nodiscard]] std::optional<SegmentPlan> planSegments(std::span<const Segment> segments, float width,
                                                      std::size_t mostLines);

/// Draws the buttons as one group. `after` is called with the number of each, right after it; `chosenInk` is
/// for the name of the chosen one. The one that was pressed, if any.
[[nodiscard]] std::optional<std::size_t>
drawSegments(std::span<const Segment> segments, const SegmentPlan& plan, std::optional<std::size_t> chosen,
             const std::function<void(std::size_t)>& after, std::optional<ImU32> chosenInk = {});

} // namespace texplorer::ui
