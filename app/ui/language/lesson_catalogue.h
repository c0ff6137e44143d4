#pragma once

#include "app/ui/language/catalogue.h"
#include "core/lesson/lesson_files.h"

#include <memory>
#include <string>

namespace texplorer::ui {

/// The file of a lesson's folder with its texts in a language: "zh_CN.po".
[[nodiscard]] std::string catalogueFileOf(Language language);

/// The texts of a lesson in a language; nullptr: it has none, or they are English. Errors: those of
/// LessonFolder::read and Catalogue::parse.
[[nodiscard]] Result<std::shared_ptr<const Catalogue>> readLessonCatalogue(const lesson::LessonFolder& folder,
                                                                           Language language);

/// The same; nullptr, too, where they can't be read.
[[nodiscard]] std::shared_ptr<const Catalogue> catalogueOfLesson(const lesson::LessonFolder& folder,
                                                                 Language language);

} // namespace texplorer::ui
