#pragma once

// The numbers in a step's texts: "{lambda}" stands for what a pixel of the picture that is shown has, however
// large that picture is.

#include "core/lesson/lesson_scene.h"
#include "core/reference/explain/explanation.h"

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::lesson {

/// Of the picture of a step on a page. Its numbers stand where no picture is shown, too.
inline constexpr PictureSize pageSize{320, 240};

/// Where a mark, in thousandths from the top left of a picture in the shape of the lessons', lies in a
/// picture of any shape: the middle stays, and both show the same height.
[[nodiscard]] reference::PixelPlace pixelOf(int x, int y, PictureSize picture);

/// What the words stand for. {color} the pixel's bytes, {fragment} what lighting or glColor gave; of its
/// first unit {s} {t} the coordinates, {side} {up} how many texels lie between it and the next pixel to the
/// side and above, {rho}, {lambda}, {level} the levels that it reads, {probes} how many an anisotropic filter
/// takes, {texels} how many texels were read, {texel} the filtered colour.
class Numbers {
public:
    /// Nothing is known: a sign stands for each.
    Numbers() = default;
    explicit Numbers(std::string_view sign);

    /// Those of the pixel that an explanation is about. What it hasn't is a dash.
    explicit Numbers(const reference::Explanation& explanation);

    /// The text with its numbers.
    [[nodiscard]] std::string in(std::string_view text) const;

    /// The word's number; empty: there is none.
    [[nodiscard]] std::string_view of(std::string_view word) const;

private:
    std::string_view sign_ = "–";
    std::vector<std::string> values_; ///< of each word, in their order; empty: none
};

/// Of the pixel that is marked in a picture of this size; dashes where none is. Errors: those of probe().
[[nodiscard]] Result<Numbers> numbersOf(const LessonScene& scene, const Look& look, PictureSize picture,
                                        std::stop_token stop = {});

/// Of all texts of a step.
struct StepNumbers {
    Numbers start;    ///< of the scene that it begins with: its text, task, question and answers
    Numbers answered; ///< of the right answer's scene: the reason
};

/// Errors: those of withEdits and numbersOf.
[[nodiscard]] Result<StepNumbers> numbersOf(const LessonScene& start, const Step& step, PictureSize picture,
                                            std::stop_token stop = {});

/// The words of a text, without braces; known or not.
[[nodiscard]] std::vector<std::string_view> wordsIn(std::string_view text);

/// Malformed: a word that there isn't.
[[nodiscard]] Result<void> checkWords(std::string_view text);

} // namespace texplorer::lesson
