#pragma once

#include "texplorer/lesson/lesson_scene.h"

#include <string>
#include <vector>

namespace texplorer::lesson {

/// The part of checkLesson for a step's mark and the numbers in its texts; `place` is the step's.
void checkMark(const LessonScene& start, const Step& step, const std::string& place,
               std::vector<Error>& problems);

} // namespace texplorer::lesson
