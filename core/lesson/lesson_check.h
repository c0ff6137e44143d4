#pragma once

#include "core/lesson/lesson_scene.h"

#include <vector>

namespace texplorer::lesson {

/// Everything in a lesson that can be wrong, by place: scenes and images that aren't there, edits that can't
/// be made, parameters that there aren't; answers whose pictures can't be told apart, a picture that is
/// reached before anything was done, in one shape of the picture at least; a fallback that nothing needs, or
/// that needs as many texture units. In pictures of several sizes: a mark on nothing, or where two texels or
/// levels are equally near, so that renderers differ; a word that has no number; a number that is typed, but
/// is another one in a picture of another size. Empty: nothing.
[[nodiscard]] std::vector<Error> checkLesson(const LessonFolder& folder, const Lesson& lesson);

} // namespace texplorer::lesson
