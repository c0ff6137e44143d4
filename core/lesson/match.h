#pragma once

#include "texplorer/image/image.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/scene/params/scene_diff.h"

#include <optional>
#include <stop_token>

namespace texplorer::lesson {

/// Pictures that are compared, or shown next to a question: Rgba8, opaque, drawn by the reference at time 0.
inline constexpr int smallWidth = 192;
inline constexpr int smallHeight = 144;

/// Errors: those of ReferenceRenderer::draw.
[[nodiscard]] Result<Image> drawSmall(const LessonScene& scene, std::stop_token stop = {},
                                      PictureSize size = {smallWidth, smallHeight});

/// Whether two such pictures look equal: at most one pixel in a thousand differs by more than 2, as in
/// conform's rule for texel edges.
[[nodiscard]] bool areAlike(const Image& a, const Image& b);

/// How close a scene is to the target.
struct Grade {
    bool passed = false;
    double share = 0; ///< share of pixels that differ, 0 to 1
};

/// Errors: those of the drawing.
[[nodiscard]] Result<Grade> gradeMatch(const Scene& scene, const Scene& target, const ImageSource& images,
                                       std::stop_token stop = {});

/// Returns the one parameter whose change brings the picture closest to the target; if no single one does,
/// the first that differs; empty if the scenes are equal. Its `to` is the target's value. Draws a picture for
/// each parameter that differs. Errors: those of drawing.
[[nodiscard]] Result<std::optional<SceneChange>>
hintFor(const Scene& scene, const Scene& target, const ImageSource& images, std::stop_token stop = {});

} // namespace texplorer::lesson
