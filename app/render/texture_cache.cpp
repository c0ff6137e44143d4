#include "app/render/texture_cache.h"

#include "core/image/mipmaps.h"
#include "core/scene/param_text.h"
#include "core/scene/target_image.h"

#include <algorithm>
#include <string>

namespace texplorer::render {

namespace {

/// "64", "64 x 32" or "64 x 32 x 8": as many axes as the target has.
std::string extents(const Image& image, Target target) {
    std::string text = std::to_string(image.width);
    if (target != Target::Texture1D)
        text += " x " + std::to_string(image.height);
    if (target == Target::Texture3D)
        text += " x " + std::to_string(image.depth);
    return text;
}

} // namespace

GLuint TextureCache::prepare(const Scene& scene, std::size_t index, Target target, const ImageSource& images,
                             GlErrors& errors) {
    const Texture& texture = scene.textures[index];
    const std::string where = "textures[" + std::to_string(index) + "]";
    std::shared_ptr<const Image> image = images.find(texture);
    if (!image || image->empty()) {
        errors.add(where + ": " +
                   (texture.file.empty() ? "no file is chosen" : texture.file + " is not loaded") +
                   "; drawn without it");
        return 0;
    }

    Slot& slot = slots_[{index, target}];
    if (slot.image != image || slot.format != texture.internalFormat || slot.mipmaps != texture.mipmaps) {
        slot = Slot{std::move(image), texture.internalFormat, texture.mipmaps, {}, {}, false};
        upload(slot, target, where);
    }
    errors.add(slot.uploadErrors.sentences());
    if (!slot.usable)
        return 0;
    if (texture.maxAnisotropy > capabilities_.maxAnisotropy)
        errors.add(where + ": an anisotropy of " + formatNumber(texture.maxAnisotropy) +
                   " exceeds the driver's " + formatNumber(capabilities_.maxAnisotropy) +
                   "; drawn with that");
    slot.object.apply(texture, capabilities_.maxAnisotropy, where, errors);
    return slot.object.name();
}

void TextureCache::upload(Slot& slot, Target target, std::string_view where) const {
    Image base = imageForTarget(*slot.image, target);
    const int limit =
        target == Target::Texture3D ? capabilities_.max3DTextureSize : capabilities_.maxTextureSize;
    if (std::max({base.width, base.height, base.depth}) > limit) {
        slot.uploadErrors.add(std::string(where) + ": " + extents(base, target) +
                              " texels exceed the driver's " + std::to_string(limit) + " for " +
                              std::string(rowOf(target).name) + "; drawn without it");
        return;
    }
    slot.object = TextureObject(target, slot.format, applyMipPolicy(slot.mipmaps, std::move(base)), where,
                                slot.uploadErrors);
    slot.usable = true;
}

void TextureCache::keepFirst(std::size_t count) {
    std::erase_if(slots_, [count](const auto& entry) { return entry.first.first >= count; });
}

} // namespace texplorer::render
