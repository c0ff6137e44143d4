#include "app/render/texture_cache.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace texplorer::render {

float unitBias(const Unit& unit, const BoundTexture& texture) {
    constexpr float limit = reference::SampleOptions{}.maxBias;
    const float sum = texture.lodBias + unit.lodBias;
    return std::abs(sum) > limit ? std::copysign(limit, sum) - texture.lodBias : unit.lodBias;
}

BoundTexture TextureCache::prepare(const TextureUse& use, Target target, const ImageSource& images,
                                   LevelsSource* levels, GlErrors& errors) {
    const std::size_t index = use.texture;
    const Texture& texture = use.scene.textures[index];
    const std::string where = fmt::format("textures[{}]", index);
    TexturePictures pictures = images.picturesOf(texture);
    if (!pictures.base || !hasPixels(*pictures.base)) {
        const Sentence reason = texture.file.empty()
                                    ? Sentence("no file is chosen")
                                    : Sentence("{0} is not loaded", ProperName{texture.file});
        errors.add(Sentence("{0}: {1}", ProperName{where}, Sentence("{0}; drawn without it", reason)));
        return {};
    }

    if (texture.oversize == Oversize::Smaller)
        pictures.limits = TextureLimits::lower(pictures.limits, facts_.limits());
    LiveTexture& slot = slots_[{index, target}];
    const LevelsRequest request{std::move(pictures), imageSettings(texture), target};
    const bool wasThere = slot.shows(request);
    slot.follow(request, &capabilities_, levels, where);
    if (!wasThere && slot.shows(request))
        ++revision_;
    errors.add(slot.errors().sentences());
    if (slot.object().name() == 0)
        return {};
    if (texture.maxAnisotropy > capabilities_.maxAnisotropy)
        errors.add(Sentence("{0}: {1}", ProperName{where},
                            Sentence("an anisotropy of {0} exceeds the driver's {1}; drawn with that",
                                     ProperName{formatNumber(texture.maxAnisotropy)},
                                     ProperName{formatNumber(capabilities_.maxAnisotropy)})));
    const AppliedTexture applied = appliedTexture(texture, slot.shape(), slot.lastLevel(), facts_, &use);
    if (!applied.completeness.complete())
        return {};
    for (const std::string_view sentence : applied.heldBack)
        errors.add(Sentence("{0}: {1}", ProperName{where}, sentence));
    slot.object().apply(applied.texture, capabilities_.maxAnisotropy, where, errors);
    const bool hasDepths = isDepth(slot.shape().internalFormat);
    return {slot.object().name(),
            slot.lateFlip(),
            hasDepths ? baseFormat(texture.depthMode) : slot.shape().format,
            slot.isUnclamped(),
            applied.texture.lodBias,
            hasDepths,
            hasDepths && texture.compareMode == CompareMode::RToTexture};
}

const TextureObject* TextureCache::find(std::size_t index, Target target) const {
    const auto found = slots_.find({index, target});
    const bool usable = found != slots_.end() && found->second.object().name() != 0;
    return usable ? &found->second.object() : nullptr;
}

std::map<std::pair<std::size_t, Target>, std::shared_ptr<const view::StoredTexture>>
TextureCache::stored() const {
    std::map<std::pair<std::size_t, Target>, std::shared_ptr<const view::StoredTexture>> all;
    for (const auto& [place, slot] : slots_) {
        if (slot.stored())
            all.emplace(place, slot.stored());
    }
    return all;
}

bool TextureCache::isUploading() const {
    return std::ranges::any_of(slots_, [](const auto& entry) { return entry.second.isUploading(); });
}

void TextureCache::keepOnly(const Scene& scene) {
    std::erase_if(slots_, [&scene](const auto& entry) {
        const auto& [index, target] = entry.first;
        return index >= scene.textures.size() ||
               std::ranges::none_of(scene.passes, [&, index = index, target = target](const Pass& pass) {
                   return std::ranges::any_of(pass.units, [&](const Unit& unit) {
                       return std::cmp_equal(unit.texture, index) && unit.target == target;
                   });
               });
    });
}

} // namespace texplorer::render
