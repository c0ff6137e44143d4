#pragma once

// Numbers in a step's texts: "{lambda}" is replaced by the value at a pixel of the shown picture, for any
// size of the picture.

#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/reference/explain/explanation.h"

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::lesson {

/// The picture of a step on a page. Its numbers are also used where no picture is shown.
inline constexpr PictureSize pageSize{320, 240};

/// Converts a mark, in thousandths from the top left of a picture of the lessons' aspect ratio, to a pixel of
/// a picture of any size: the centre and the visible height stay the same.
[[nodiscard]] reference::PixelPlace pixelOf(int x, int y, PictureSize picture);

/// The pixel of a picture of another size that shows the same: the centre and the visible height stay the
/// same, enlarged by `zoom`. The nearest one if it is outside.
[[nodiscard]] reference::PixelPlace pixelOf(reference::PixelPlace pixel, PictureSize from, PictureSize to,
                                            double zoom = 1);

/// The values of the words. {color} the pixel's bytes, {fragment} the colour of lighting or glColor; of its
/// first unit: {s} {t} the coordinates, {side} {up} the distances in texels to the next pixel to the side and
/// above, {rho}, {lambda}, {level} the levels that are read, {probes} the number of samples of an anisotropic
/// filter, {texels} the number of texels read, {texel} the filtered colour.
class Numbers {
public:
    /// No values: each word is replaced by a sign.
    Numbers() = default;
    explicit Numbers(std::string_view sign);

    /// The values of an explained pixel. Missing ones are a dash.
    explicit Numbers(const reference::Explanation& explanation);

    /// Replaces the words of a text.
    [[nodiscard]] std::string in(std::string_view text) const;

    /// The value of a word; empty: unknown word.
    [[nodiscard]] std::string_view of(std::string_view word) const;

private:
    std::string_view sign_ = "–";
    std::vector<std::string> values_; ///< of each word, in order; empty: none
};

/// Returns the values at the marked pixel in a picture of this size; dashes without a mark. Errors: those of
/// probe().
[[nodiscard]] Result<Numbers> numbersOf(const LessonScene& scene, const Look& look, PictureSize picture,
                                        std::stop_token stop = {});

/// The values for all texts of a step.
struct StepNumbers {
    Numbers start;    ///< for the starting scene: text, task, question and answers
    Numbers answered; ///< for the scene of the right answer: the reason
};

/// Errors: those of withEdits and numbersOf.
[[nodiscard]] Result<StepNumbers> numbersOf(const LessonScene& start, const Step& step, PictureSize picture,
                                            std::stop_token stop = {});

/// Returns the words of a text, without braces, known or not.
[[nodiscard]] std::vector<std::string_view> wordsIn(std::string_view text);

/// Malformed: an unknown word.
[[nodiscard]] Result<void> checkWords(std::string_view text);

} // namespace texplorer::lesson
