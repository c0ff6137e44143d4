#pragma once

// An Explanation as text, for terminals and windows: the stages of OpenGL in order, as steps that can be
// collapsed.

#include "texplorer/base/sentence.h"
#include "texplorer/base/translatable.h"
#include "texplorer/reference/explain/explanation.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::reference {

/// The colour of a number: s is red, t green and r blue everywhere.
enum class Ink : std::uint8_t { Plain, S, T, R, Q, Dim, Good, Bad };

struct StepCell {
    Sentence text;
    Ink ink = Ink::Plain;
};

/// A row of a small table; or a sentence, as a label without cells.
struct StepRow {
    Sentence label;
    std::vector<StepCell> cells{};
    std::optional<glm::vec4> swatch{}; ///< the colour that the row describes
    bool heading = false;              ///< contains the headings of the rows below
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
    int unit = -1; ///< the texture unit that it describes; -1: none
    Sentence title;
    Sentence summary;                  ///< the result
    std::optional<glm::vec4> swatch{}; ///< the same as a colour
    std::vector<StepRow> rows{};
};

struct FragmentSteps {
    Sentence title;   ///< "Sphere, Stack 3, triangle 17 (models[1], pass 0)"
    Sentence outcome; ///< "drawn", "failed the depth test"
    bool drawn = true;
    std::vector<Step> steps;
};

[[nodiscard]] FragmentSteps stepsOf(const FragmentExplanation& fragment);
[[nodiscard]] std::vector<FragmentSteps> stepsOf(const Explanation& explanation);

/// Tells which of a pixel's fragments are explained; empty: all.
[[nodiscard]] Sentence cutSentence(const Explanation& explanation);

/// Whether a renderer's pixel is a correct result of the reference with other decisions of ties, within
/// `tolerance`.
[[nodiscard]] bool isAsRight(const Explanation& explanation, const PixelBytes& bytes, int tolerance);

/// The largest difference of a component.
[[nodiscard]] int differenceOf(const PixelBytes& one, const PixelBytes& other);

/// The names of colour components that users read.
inline constexpr std::array componentNames{N_("red"), N_("green"), N_("blue"), N_("alpha")};

/// A label with leading spaces, which mark it as part of the row above.
[[nodiscard]] Sentence indented(const Sentence& label);

/// A row of component names as headings.
[[nodiscard]] StepRow componentHeading(Sentence label);

/// "181 90 12 255".
[[nodiscard]] std::string bytesText(const PixelBytes& bytes);

/// A number for users: at most four decimal places; large numbers with an exponent.
[[nodiscard]] std::string numberText(float value);

/// The same, with enough digits to distinguish it from `other`.
[[nodiscard]] std::string numberText(float value, float other);

/// "12.5" for a share of 0.125. Values other than 0 and 1 never read 0 or 100: "< 0.1".
[[nodiscard]] std::string percentText(float share);

/// The same for amounts, where it matters that they are not 0: "< 0.0001".
[[nodiscard]] std::string amountText(float value);

/// With a fixed number of decimal places, so that a column is aligned.
[[nodiscard]] std::string columnText(float value, int digits = 4);

} // namespace texplorer::reference
