#include "app/ui/parameters/texture_thumbnail.h"

#include "app/ui/language/translate.h"
#include "texplorer/text/printable.h"
#include "texplorer/texture/texture_levels.h"

#include <filesystem>

namespace texplorer::ui {

std::shared_ptr<const LevelsSummary> summaryOf(const Session& session, const Texture& texture,
                                               Target target) {
    return session.services.levels.summary(
        {session.document.images.picturesOf(texture), imageSettings(texture), target});
}

std::shared_ptr<const Image> thumbnailOf(const Session& session, const Texture& texture, Target target) {
    const std::shared_ptr<const LevelsSummary> summary = summaryOf(session, texture, target);
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

const Texture* textureOf(const Scene& scene, const Unit& unit) {
    const bool exists = unit.texture >= 0 && static_cast<std::size_t>(unit.texture) < scene.textures.size();
    return exists ? &scene.textures[static_cast<std::size_t>(unit.texture)] : nullptr;
}

} // namespace texplorer::ui
