#pragma once

#include "texplorer/base/sentence.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// A button of a choice that shows all its buttons.
struct Segment {
    Sentence text;               ///< in English
    std::string_view group = {}; ///< those of a group are on separate lines, which begin with its name
};

/// The layout of a choice's buttons in a width, in pixels.
struct SegmentPlan {
    struct Line {
        std::string_view group;
        std::vector<float> widths; ///< of its buttons
    };
    std::vector<Line> lines;
    float names = 0; ///< width of the groups' names on the left
};

/// The gap between two buttons, and between two lines of them.
[[nodiscard]] float segmentGap();

/// The plan with the fewest lines in which no text is cut; nothing if more lines would be needed.
[[nodiscard]] std::optional<SegmentPlan> planSegments(std::span<const Segment> segments, float width,
                                                      std::size_t maxLines);

/// Draws the buttons as one group. `after` is called with each button's index, right after it; `chosenInk` is
/// for the name of the chosen one. Returns the pressed one, if any.
[[nodiscard]] std::optional<std::size_t>
drawSegments(std::span<const Segment> segments, const SegmentPlan& plan, std::optional<std::size_t> chosen,
             const std::function<void(std::size_t)>& after, std::optional<ImU32> chosenInk = {});

/// The same on as few lines as this width needs; nothing is drawn if one of them does not fit.
[[nodiscard]] std::optional<std::size_t> drawSegments(std::span<const Segment> segments, float width,
                                                      std::optional<std::size_t> chosen,
                                                      const std::function<void(std::size_t)>& after);

/// A button for each of these choices, with the text that `textOf` gives.
template<class Choices, class TextOf>
[[nodiscard]] std::vector<Segment> segmentsOf(const Choices& choices, const TextOf& textOf) {
    std::vector<Segment> segments;
    for (const auto& choice : choices)
        segments.push_back({std::invoke(textOf, choice)});
    return segments;
}

/// The index of a choice; nothing if it is not one of them.
template<class Choices, class Choice, class PartOf = std::identity>
[[nodiscard]] std::optional<std::size_t> indexIn(const Choices& choices, const Choice& choice,
                                                 PartOf partOf = {}) {
    const auto found = std::ranges::find(choices, choice, partOf);
    if (found == std::ranges::end(choices))
        return std::nullopt;
    return static_cast<std::size_t>(std::distance(std::ranges::begin(choices), found));
}

} // namespace texplorer::ui
