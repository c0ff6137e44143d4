#include "app/ui/language/translate.h"
#include "app/ui/model/level_view.h"
#include "app/ui/parameters/sections.h"
#include "texplorer/text/printable.h"

#include <filesystem>

namespace texplorer::ui {

std::shared_ptr<const Image> thumbnailOf(const Session& session, const Texture& texture, Target target) {
    const std::shared_ptr<const LevelsSummary> summary =
        summaryOf(session, levelsOf(session, texture, target));
    return summary && !summary->levels.empty() ? summary->levels.front().second : nullptr;
}

std::string nameOfImage(const Texture& texture) {
    if (texture.source == SourceKind::Pattern)
        return std::string(rowOf(texture.pattern).label);
    return texture.source == SourceKind::File
               ? printable(std::filesystem::path(texture.file).filename().string())
               : std::string(rowOf(texture.source).label); // of the light's view
}

std::string shownNameOfImage(const Texture& texture) {
    const std::string name = nameOfImage(texture);
    return texture.source == SourceKind::File ? name : tr(name);
}

} // namespace texplorer::ui
