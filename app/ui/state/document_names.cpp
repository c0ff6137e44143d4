#include "app/ui/state/document_names.h"

#include "texplorer/texture/image_source.h"

namespace texplorer::ui {

Names namesIn(const Document& document) {
    Names names;
    for (const Model& model : document.scene.models) {
        if (!model.name.empty())
            names.insert(model.name);
    }
    for (const std::string& file : filesOf(document.scene)) {
        names.insert(file);
        names.insert(std::filesystem::path(file).filename().string());
    }
    if (!document.file.empty()) {
        names.insert(document.file.string());
        names.insert(document.file.filename().string());
    }
    return names;
}

} // namespace texplorer::ui
