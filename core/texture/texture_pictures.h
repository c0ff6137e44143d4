#pragma once

#include "texplorer/image/texture_image.h"
#include "texplorer/scene/scene.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace texplorer {

/// The images that a texture is made of, from ImageSource. They are shared and immutable; two values are
/// equal if the images are the same objects, so they can be keys of a cache.
struct TexturePictures {
    using Picture = std::shared_ptr<const TextureImage>; ///< nullptr: not loaded

    TexturePictures() = default;
    TexturePictures(Picture of) // NOLINT: implicit, as most textures are made of one
        : base(std::move(of)) {}

    Picture base;
    std::vector<Picture> levels; ///< of Texture::levels; fewer or none if the others are not loaded
    std::vector<Picture> others; ///< of Texture::preparation; nullptr also for steps without another picture
    std::vector<Picture> subimages; ///< of Texture::subimages

    [[nodiscard]] const TextureImage* level(std::size_t index) const {
        return index < levels.size() ? levels[index].get() : nullptr;
    }
    [[nodiscard]] const TextureImage* other(std::size_t index) const {
        return index < others.size() ? others[index].get() : nullptr;
    }
    [[nodiscard]] const TextureImage* subimage(std::size_t index) const {
        return index < subimages.size() ? subimages[index].get() : nullptr;
    }

    bool operator==(const TexturePictures&) const = default;
};

} // namespace texplorer
