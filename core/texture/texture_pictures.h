#pragma once

#include "core/image/texture_image.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace texplorer {

/// The images that a texture is made of, as ImageSource has them. They are shared and never change; two are
/// equal where they are the same images, so that they can key a cache.
struct TexturePictures {
    using Picture = std::shared_ptr<const TextureImage>; ///< nullptr: not loaded

    TexturePictures() = default;
    TexturePictures(Picture of) // NOLINT: most textures are made of one
        : base(std::move(of)) {}

    Picture base;
    std::vector<Picture> levels; ///< of Texture::levels; fewer, and none, where the others aren't loaded
    std::vector<Picture> others; ///< of Texture::preparation; nullptr for steps without another picture, too

    [[nodiscard]] const TextureImage* level(std::size_t index) const {
        return index < levels.size() ? levels[index].get() : nullptr;
    }
    [[nodiscard]] const TextureImage* other(std::size_t index) const {
        return index < others.size() ? others[index].get() : nullptr;
    }

    bool operator==(const TexturePictures&) const = default;
};

} // namespace texplorer
