#pragma once

#include "app/ui/language/catalogue.h"
#include "texplorer/lesson/lesson_files.h"

#include <memory>
#include <string>

namespace texplorer::ui {

/// The texts of a lesson in a language; nullptr if it has none, or for English. Errors: those of
/// LessonFolder::read and Catalogue::parse.
[[nodiscard]] Result<std::shared_ptr<const Catalogue>> readLessonCatalogue(const lesson::LessonFolder& folder,
                                                                           Language language);

/// The same; also nullptr if they cannot be read.
[[nodiscard]] std::shared_ptr<const Catalogue> catalogueOfLesson(const lesson::LessonFolder& folder,
                                                                 Language language);

} // namespace texplorer::ui
