#pragma once

// A step of a lesson on the page of lessons.

#include "app/screenshot/reports/lesson_page.h"
#include "app/screenshot/reports/page_words.h"
#include "texplorer/lesson/lesson.h"

#include <stop_token>

namespace texplorer::screenshot {

/// A lesson that is on the page.
struct PageLesson {
    lesson::LessonFolder folder;
    lesson::Lesson lesson;
    std::string anchor; ///< what its links and files are called, "wrap"
    PageWords words;
    std::string window{}; ///< the address of the lesson in a browser's window; empty: there is none
};

struct PageStep {
    std::string section;           ///< of the page
    std::string answer{};          ///< for the pages with answers, which are printed last; empty: none
    std::vector<PageFile> files{}; ///< pictures and programs
};

[[nodiscard]] Result<PageStep> pageStep(const PageLesson& lesson, std::size_t index,
                                        const std::stop_token& stop);

} // namespace texplorer::screenshot
