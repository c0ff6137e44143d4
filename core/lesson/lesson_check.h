#pragma once

#include "texplorer/lesson/lesson_scene.h"

#include <vector>

namespace texplorer::lesson {

/// Returns all errors of a lesson, by place: missing scenes and images, impossible edits, unknown parameters;
/// answers whose pictures look equal, or a picture that is reached without changes, in at least one aspect
/// ratio; a fallback that is never needed, or that needs as many texture units. For pictures of several
/// sizes: a mark on the background, or on a tie between two texels or levels, where renderers differ; a word
/// without a number; a literal number in a text that depends on the size. Empty: no errors.
[[nodiscard]] std::vector<Error> checkLesson(const LessonFolder& folder, const Lesson& lesson);

} // namespace texplorer::lesson
