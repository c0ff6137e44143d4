#include "app/ui/language/lesson_catalogue.h"

#include <utility>
#include <vector>

namespace texplorer::ui {

Result<std::shared_ptr<const Catalogue>> readLessonCatalogue(const lesson::LessonFolder& folder,
                                                             Language language) {
    const std::string file = catalogueFileOf(language);
    if (language == Language::English || !folder.has(file))
        return std::shared_ptr<const Catalogue>();
    const Result<std::string> text = folder.readText(file);
    if (!text)
        return fail(text.error());
    const std::vector<CatalogueFile> files{{file, *text}};
    return Catalogue::parse(language, files).map([](Catalogue catalogue) {
        return std::shared_ptr<const Catalogue>(std::make_shared<const Catalogue>(std::move(catalogue)));
    });
}

std::shared_ptr<const Catalogue> catalogueOfLesson(const lesson::LessonFolder& folder, Language language) {
    return readLessonCatalogue(folder, language).value_or(nullptr);
}

} // namespace texplorer::ui
