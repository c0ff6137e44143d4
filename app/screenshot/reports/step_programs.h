#pragma once

// The programs of a lesson's step, on the page of lessons.

#include "app/screenshot/reports/lesson_step.h"
#include "texplorer/lesson/lesson_scene.h"

namespace texplorer::screenshot {

struct StepPrograms {
    std::string excerpt; ///< HTML: the calls that the step is about; empty: no call is
    std::string whole;   ///< HTML: all of the program, folded, and what the files are called
    std::vector<PageFile> files;
};

/// `place`: what the programs are called, "wrap-3". Of each flavour there is a file, or a sentence that says
/// why not. Errors: files that can't be read.
[[nodiscard]] Result<StepPrograms> stepPrograms(const PageLesson& lesson, std::size_t index,
                                                const lesson::LessonScene& scene, const std::string& place);

/// The calls and values of a step's program that it has only after a change of its scene, each on a line;
/// empty: none, or the one scene or the other has no program.
[[nodiscard]] std::string newCallsHtml(const PageLesson& lesson, std::size_t index,
                                       const lesson::LessonScene& before, const lesson::LessonScene& after);

} // namespace texplorer::screenshot
