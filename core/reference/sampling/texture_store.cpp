#include "texplorer/reference/sampling/texture_store.h"

#include "texplorer/reference/sampling/completeness.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::reference {

bool isSampled(const Scene& scene, std::size_t texture, Target target) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return pass.enabled && std::ranges::any_of(pass.units, [&](const Unit& unit) {
                   return unit.enabled && std::cmp_equal(unit.texture, texture) && unit.target == target;
               });
    });
}

/// Without pictures where the work was stopped: the next one asks again.
TextureStore::Slot TextureStore::filled(TexturePictures pictures, Texture settings, Target target,
                                        const LevelWork& work, const std::string& where) {
    Slot slot;
    const Result<TextureLevels> levels = prepareLevels(settings, pictures, target, work);
    if (levels)
        slot.notes = levels->notes;
    Result<SampledTexture> sampled =
        levels ? sampledTexture(settings, *levels, target, slot.notes, work.stop) : fail(levels.error());
    if (sampled) {
        slot.texture.sampled = *std::move(sampled);
        slot.texture.lateFlip = levels->lateFlip;
        if (levels->call)
            slot.texture.uploaded = std::make_shared<const TextureLevels>(*levels);
        slot.lastLevel = levels->lastLevel;
        slot.usable = true;
    } else if (sampled.error().code == ErrorCode::Cancelled)
        return {};
    else
        slot.notes = {Sentence("{0}; drawn without it", describe(sampled.error()))};
    for (Sentence& note : slot.notes)
        note = Sentence("{0}: {1}", ProperName{where}, note);
    slot.pictures = std::move(pictures);
    slot.settings = std::move(settings);
    return slot;
}

const StoredTexture* TextureStore::prepare(const Scene& scene, std::size_t index, Target target,
                                           const ImageSource& images, const LevelWork& work,
                                           std::vector<Sentence>& problems) {
    const Texture& texture = scene.textures[index];
    const std::string where = fmt::format("textures[{}]", index);
    const auto say = [&problems](const Sentence& sentence) {
        if (std::ranges::find(problems, sentence) == problems.end())
            problems.push_back(sentence);
    };
    TexturePictures pictures = images.picturesOf(texture);
    if (!pictures.base || !hasPixels(*pictures.base)) {
        const Sentence reason = texture.file.empty()
                                    ? Sentence("no file is chosen")
                                    : Sentence("{0} is not loaded", ProperName{texture.file});
        say(Sentence("{0}: {1}", ProperName{where}, Sentence("{0}; drawn without it", reason)));
        return nullptr;
    }
    Slot& slot = slots_[{index, target}];
    if (Texture settings = imageSettings(texture); slot.pictures != pictures || slot.settings != settings) {
        slot = Slot{}; // before the new one takes its memory
        slot = filled(std::move(pictures), std::move(settings), target, work, where);
        slot.texture.version = ++versions_;
    }
    std::ranges::for_each(slot.notes, say);
    if (!slot.usable)
        return nullptr;
    setParameters(slot.texture.sampled, texture, slot.lastLevel);
    slot.texture.complete = checkCompleteness(slot.texture.sampled).complete();
    return &slot.texture;
}

void TextureStore::keepOnly(const Scene& scene) {
    std::erase_if(slots_, [&scene](const auto& entry) {
        return !isSampled(scene, entry.first.first, entry.first.second);
    });
}

} // namespace texplorer::reference
