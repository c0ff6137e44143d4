#include "app/render/texture_cache.h"

#include "core/scene/param_text.h"

#include <algorithm>
#include <string>

namespace texplorer::render {

namespace {

/// "64", "64 x 32" or "64 x 32 x 8": as many axes as the target has.
std::string extents(const Surface& surface, Target target) {
    std::string text = std::to_string(widthOf(surface));
    if (target != Target::Texture1D)
        text += " x " + std::to_string(heightOf(surface));
    if (target == Target::Texture3D)
        text += " x " + std::to_string(depthOf(surface));
    return text;
}

} // namespace

BoundTexture TextureCache::prepare(const Scene& scene, std::size_t index, Target target,
                                   const ImageSource& images, GlErrors& errors) {
    const Texture& texture = scene.textures[index];
    const std::string where = "textures[" + std::to_string(index) + "]";
    std::shared_ptr<const TextureImage> image = images.find(texture);
    if (!image || image->surfaces.empty() || byteCount(image->surfaces.front()) == 0) {
        errors.add(where + ": " +
                   (texture.file.empty() ? "no file is chosen" : texture.file + " is not loaded") +
                   "; drawn without it");
        return {};
    }

    Slot& slot = slots_[{index, target}];
    if (Texture settings = imageSettings(texture); slot.image != image || slot.settings != settings) {
        slot = Slot{};
        slot.image = std::move(image);
        slot.settings = std::move(settings);
        upload(slot, target, where);
    }
    errors.add(slot.uploadErrors.sentences());
    if (!slot.usable)
        return {};
    if (texture.maxAnisotropy > capabilities_.maxAnisotropy)
        errors.add(where + ": an anisotropy of " + formatNumber(texture.maxAnisotropy) +
                   " exceeds the driver's " + formatNumber(capabilities_.maxAnisotropy) +
                   "; drawn with that");
    Texture applied = texture;
    applied.maxLevel = std::min(applied.maxLevel, slot.lastLevel);
    slot.object.apply(applied, capabilities_.maxAnisotropy, where, errors);
    return {slot.object.name(), slot.lateFlip};
}

void TextureCache::upload(Slot& slot, Target target, std::string_view where) const {
    Result<TextureLevels> levels = prepareLevels(slot.settings, *slot.image, target);
    const auto report = [&](const std::string& sentence) {
        slot.uploadErrors.add(std::string(where) + ": " + sentence);
    };
    if (!levels)
        return report(describe(levels.error()) + "; drawn without it");
    const Surface& base = levels->levels.front().surface;
    const int limit =
        target == Target::Texture3D ? capabilities_.max3DTextureSize : capabilities_.maxTextureSize;
    if (std::max({widthOf(base), heightOf(base), depthOf(base)}) > limit)
        return report(extents(base, target) + " texels exceed the driver's " + std::to_string(limit) +
                      " for " + std::string(rowOf(target).name) + "; drawn without it");
    for (const std::string& note : levels->notes)
        report(note);
    decompressForDriver(*levels, where, slot.uploadErrors);
    slot.object = TextureObject(target, slot.settings.internalFormat, *levels, where, slot.uploadErrors);
    slot.lastLevel = levels->lastLevel;
    slot.lateFlip = levels->lateFlip;
    slot.usable = true;
}

/// The fallback for a driver that lacks the format.
void TextureCache::decompressForDriver(TextureLevels& levels, std::string_view where,
                                       GlErrors& errors) const {
    std::optional<BlockFormat> format = levels.driverFormat;
    if (const auto* blocks = std::get_if<BlockImage>(&levels.levels.front().surface))
        format = blocks->format;
    if (!format || (isS3tc(*format) ? capabilities_.s3tc : capabilities_.rgtc))
        return;
    const EnumRow& row = rowOf(*format);
    errors.add(std::string(where) + ": the driver has no " + std::string(row.name) +
               (row.since.starts_with("GL_") ? " (" + std::string(row.since) + ")" : "") +
               "; uploaded decompressed");
    decompress(levels);
}

const TextureObject* TextureCache::find(std::size_t index, Target target) const {
    const auto found = slots_.find({index, target});
    return found != slots_.end() && found->second.usable ? &found->second.object : nullptr;
}

void TextureCache::keepFirst(std::size_t count) {
    std::erase_if(slots_, [count](const auto& entry) { return entry.first.first >= count; });
}

} // namespace texplorer::render
