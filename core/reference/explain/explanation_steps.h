#pragma once

// An Explanation in words, for a terminal and for a window alike: what OpenGL did, in its order, as steps
// that can be folded.

#include "core/base/word.h"
#include "core/reference/explain/explanation.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::reference {

/// What colour a reader gives a number: s is red, t green and r blue everywhere.
enum class Ink : std::uint8_t { Plain, S, T, R, Q, Dim, Good, Bad };

struct StepCell {
    std::string text;
    Ink ink = Ink::Plain;
};

/// A line of a small table, or a sentence: the label alone.
struct StepRow {
    std::string label;
    std::vector<StepCell> cells{};
    std::optional<glm::vec4> swatch{}; ///< the colour that the line is about
    bool heading = false;              ///< names the columns of the rows below
    Ink ink = Ink::Plain;              ///< of the label
};

enum class StepKind : std::uint8_t {
    Triangle,
    PrimaryColor,
    Coordinates,
    LevelOfDetail,
    Wrap,
    Texels,
    Environment,
    IdleUnit,
    ColorSum,
    Fog,
    AlphaTest,
    DepthTest,
    Blending,
    Framebuffer,
};

struct Step {
    StepKind kind = StepKind::Triangle;
    int unit = -1; ///< the texture unit that it is about; -1: none
    std::string title;
    std::string summary;               ///< what came of it
    std::optional<glm::vec4> swatch{}; ///< the same as a colour
    std::vector<StepRow> rows{};
};

struct FragmentSteps {
    std::string title;   ///< "Sphere, Stack 3, triangle 17 (models[1], pass 0)"
    std::string outcome; ///< "drawn", "failed the depth test"
    bool drawn = true;
    std::vector<Step> steps;
};

[[nodiscard]] FragmentSteps stepsOf(const FragmentExplanation& fragment);
[[nodiscard]] std::vector<FragmentSteps> stepsOf(const Explanation& explanation);

/// Which of a pixel's fragments are explained; empty: all.
[[nodiscard]] std::string cutSentence(const Explanation& explanation);

/// Whether a renderer's pixel is what the reference has where ties fall otherwise, within `tolerance`.
[[nodiscard]] bool isAsRight(const Explanation& explanation, const PixelBytes& bytes, int tolerance);

/// The largest difference of a component.
[[nodiscard]] int differenceOf(const PixelBytes& one, const PixelBytes& other);

/// The components of a colour, as readers know them.
inline constexpr std::array componentNames{word("red"), word("green"), word("blue"), word("alpha")};

/// A label that is told by the spaces before it to belong to what stands above.
[[nodiscard]] std::string indented(std::string_view label);

/// A line with the components' names above their columns.
[[nodiscard]] StepRow componentHeading(std::string label);

/// "181 90 12 255".
[[nodiscard]] std::string bytesText(const PixelBytes& bytes);

/// A number for a reader: at most four digits after the point, a power of ten for what is large.
[[nodiscard]] std::string numberText(float value);

/// The same, with as many digits as tell it from `other`, which it is compared with.
[[nodiscard]] std::string numberText(float value, float other);

/// "12.5", of a share of 0.125. What isn't 0 or 100 doesn't read so: "< 0.1".
[[nodiscard]] std::string percentText(float share);

/// The same, of which one wants to know that it isn't 0: "< 0.0001".
[[nodiscard]] std::string amountText(float value);

/// With so many digits after the point that numbers in a column stand below each other.
[[nodiscard]] std::string columnText(float value, int digits = 4);

} // namespace texplorer::reference
