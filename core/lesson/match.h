#pragma once

#include "core/image/image.h"
#include "core/lesson/lesson_scene.h"
#include "core/scene/params/scene_diff.h"

#include <optional>
#include <stop_token>

namespace texplorer::lesson {

/// Pictures that are compared and shown beside a question: Rgba8, opaque, drawn by the reference at time 0.
inline constexpr int smallWidth = 192;
inline constexpr int smallHeight = 144;

/// Errors: those of ReferenceRenderer::draw.
[[nodiscard]] Result<Image> drawSmall(const LessonScene& scene, std::stop_token stop = {},
                                      PictureSize size = {smallWidth, smallHeight});

/// Whether nobody could tell two such pictures apart: as conform holds two renderers to its rule for the
/// edges of texels, at most a pixel in a thousand differs by more than 2.
[[nodiscard]] bool areAlike(const Image& a, const Image& b);

/// How near a scene is to the one that is to be reached.
struct Grade {
    bool passed = false;
    double share = 0; ///< of the pixels that still differ, 0 to 1
};

/// Errors: those of the drawing.
[[nodiscard]] Result<Grade> gradeMatch(const Scene& scene, const Scene& target, const ImageSource& images,
                                       std::stop_token stop = {});

/// The one parameter whose change brings the picture nearest to that of the target; where no single one does,
/// the first that differs; none: the scenes are the same. Its `to` is the value that is looked for. A picture
/// is drawn for each parameter that differs. Errors: those of the drawing.
[[nodiscard]] Result<std::optional<SceneChange>>
hintFor(const Scene& scene, const Scene& target, const ImageSource& images, std::stop_token stop = {});

} // namespace texplorer::lesson
