#pragma once

#include "app/ui/language/language.h"
#include "texplorer/base/bytes.h"
#include "texplorer/lesson/lesson_files.h"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace texplorer::screenshot {

struct PageFile {
    std::string name; ///< "wrap-1.png", "programs/wrap/wrap-1.c"
    Bytes bytes;
};

struct LessonPageOptions {
    std::vector<lesson::LessonFolder> folders; ///< in the order in which they are shown
    ui::Language language = ui::Language::English;
    std::string window{}; ///< the address of the window in a browser, to which steps link; empty: they do not
    std::function<void(float done)> progress; ///< called from several threads
    std::stop_token stop;
};

/// Whether a page may be written there: into what isn't there, is empty or holds an earlier page. Others'
/// files, as a lesson's own, might bear the names of the page's.
[[nodiscard]] Result<void> checkPageFolder(const std::filesystem::path& folder);

/// Lessons to be read, or to be printed: index.html, beside it the pictures of each step, drawn by the
/// reference, and its programs, with the image files that they read. Errors: what can't be read or drawn of a
/// lesson; Cancelled.
[[nodiscard]] Result<std::vector<PageFile>> lessonPage(const LessonPageOptions& options);

} // namespace texplorer::screenshot
