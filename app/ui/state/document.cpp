#include "app/ui/state/document.h"

#include "app/ui/language/translate.h"
#include "texplorer/text/printable.h"

#include <utility>

namespace texplorer::ui {

Document::Document(Scene start, ImageSource source, std::filesystem::path savedAs)
    : scene(start)
    , history(start)
    , saved(std::move(start))
    , images(std::move(source))
    , file(std::move(savedAs))
    , needsFit(file.empty() || scene.view == defaultScene().view)
    , used(filesOf(scene)) {}

bool isDirty(const Document& document) {
    if (document.isLessons)
        return false;
    if (!document.file.empty())
        return document.scene != document.saved;
    const Scene& a = document.scene;
    const Scene& b = document.saved;
    return a.light != b.light || a.material != b.material || a.models != b.models ||
           a.textures != b.textures || a.passes != b.passes || a.timeline != b.timeline;
}

std::string nameOf(const Document& document) {
    const std::filesystem::path& file = document.file.empty() ? document.suggested : document.file;
    const std::filesystem::path name = file.stem();
    return (name.extension() == ".texplorer" ? name.stem() : name).string();
}

std::string fileNameOf(const Document& document, std::string_view end) {
    const std::string name = nameOf(document);
    return (name.empty() ? "scene" : name) + std::string(end);
}

std::string windowTitle(const Document& document) {
    const std::filesystem::path& file = document.file.empty() ? document.suggested : document.file;
    const std::string name = file.empty() ? tr("Untitled") : file.filename().string();
    return printable(name) + (isDirty(document) ? " • Texplorer" : " - Texplorer");
}

} // namespace texplorer::ui
