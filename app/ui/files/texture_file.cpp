#include "app/ui/files/texture_file.h"

#include "texplorer/codec/registry.h"
#include "texplorer/reference/light_depth.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

const CodecRow& codecOf(const TextureSaving& saving) {
    return *std::ranges::find(codecRows(), saving.file, &CodecRow::name);
}

TextureSaving savingOf(const Session& session) {
    TextureSaving saving = session.saving;
    saving.target = selectedUnit(session).target;
    return saving;
}

/// What the file lacks, and how it differs.
Sentence remarkOn(const SavedTexture& saved) {
    std::vector<Sentence> sentences = saved.remarks;
    if (!saved.losses.empty())
        sentences.insert(sentences.begin(), Sentence("Lost: {0}.", allLost(saved.losses)));
    return Sentence::joined("{0} {1}", sentences);
}

/// The inputs of a texture's file.
struct TextureOrder {
    Scene scene; ///< at the present time
    std::size_t texture;
    ImageSource images;
    double time;
    TextureSaving saving;
};

Result<MadeFile> madeOf(TextureOrder order, const FileMaking& making) {
    const Texture& texture = order.scene.textures[order.texture];
    if (texture.source == SourceKind::LightDepth)
        order.images.putLightDepth(
            texture.depthSize, drawnImage(reference::drawLightDepths(order.scene, order.time,
                                                                     texture.depthSize, making.levels.stop)));
    if (texture.source == SourceKind::Picture) {
        Result<ImageSource> drawn = reference::ReferenceRenderer().drawnImages(
            {order.scene, order.images, order.time}, {.stop = making.levels.stop});
        if (!drawn)
            return fail(drawn.error());
        order.images = std::move(*drawn);
    }
    LevelWork work = making.levels;
    work.progress = making.report;
    const Result<SavedTexture> saved =
        savedTexture(texture, order.images.picturesOf(texture), order.saving, work);
    if (!saved)
        return fail(saved.error());
    return codecOf(order.saving).encode(saved->image, {}).map([&](Bytes bytes) {
        return MadeFile{std::move(bytes), remarkOn(*saved)};
    });
}

} // namespace

Sentence textureRefusal(const Session& session) {
    const Texture* texture = boundTexture(session);
    if (!texture)
        return N_("No texture is bound to the selected unit.");
    if (!boundImage(session))
        return N_("Its image is not loaded.");
    return {};
}

LevelPlan levelsToSave(const Session& session) {
    const Texture* texture = boundTexture(session);
    if (!texture)
        return {};
    return planLevels(*texture, session.document.images.picturesOf(*texture), selectedUnit(session).target);
}

Result<std::vector<PlannedLevel>> savedLevels(const Session& session) {
    if (Sentence refusal = textureRefusal(session); !refusal.empty())
        return fail(ErrorCode::NotFound, std::move(refusal));
    LevelPlan plan = levelsToSave(session);
    const TextureSaving saving = savingOf(session);
    if (const Result<void> possible = checkSaving(plan, saving); !possible)
        return fail(possible.error());
    if (!saving.hasAllLevels())
        std::erase_if(plan.levels, [&](const PlannedLevel& level) { return level.number != saving.level; });
    return std::move(plan.levels);
}

Result<FileOrder> textureOrder(const Session& session, std::filesystem::path file) {
    return savedLevels(session).map([&](const auto&) {
        const Scene& scene = presentScene(session);
        TextureOrder order{scene, static_cast<std::size_t>(boundTexture(session) - scene.textures.data()),
                           session.document.images, session.look.playback.time, savingOf(session)};
        return FileOrder{
            std::move(file), N_("The texture can't be written: {0}."), 0,
            [order = std::move(order)](const FileMaking& making) { return madeOf(order, making); }};
    });
}

std::string textureFileName(const Session& session) {
    const std::string extension = extensionsOf(codecOf(session.saving)).front();
    const Texture* texture = boundTexture(session);
    if (!texture || isDrawn(texture->source))
        return fileNameOf(session.document, "-depths" + extension);
    if (texture->source == SourceKind::Pattern)
        return std::string(rowOf(texture->pattern).name) + extension;
    const std::filesystem::path image = std::filesystem::path(texture->file).filename();
    const bool hasItsName = codecForExtension(image.string()) == &codecOf(session.saving);
    return image.stem().string() + (hasItsName ? "-texture" : "") + extension;
}

Result<void> saveTextureFile(Session& session, const std::filesystem::path& file,
                             const std::optional<FileFingerprint>& replaces) {
    return textureOrder(session, file).and_then([&](FileOrder order) {
        return session.services.writing->writeAs(std::move(order),
                                                 extensionsOf(codecOf(session.saving)).front(), replaces);
    });
}

} // namespace texplorer::ui
