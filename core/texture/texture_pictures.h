#pragma once

#include "texplorer/gl/sampling.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/scene/scene.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace texplorer {

/// The largest base level that a driver takes, in texels along each axis. The default takes any.
struct TextureLimits {
    int size = 1 << 30; ///< GL_MAX_TEXTURE_SIZE
    int size3D = 1 << 30;
    int sizeOfCubeMap = 1 << 30;

    [[nodiscard]] constexpr int of(Target target) const {
        return target == Target::Texture3D ? size3D : target == Target::CubeMap ? sizeOfCubeMap : size;
    }
    [[nodiscard]] static constexpr TextureLimits lower(const TextureLimits& one, const TextureLimits& other) {
        return {std::min(one.size, other.size), std::min(one.size3D, other.size3D),
                std::min(one.sizeOfCubeMap, other.sizeOfCubeMap)};
    }

    bool operator==(const TextureLimits&) const = default;
};

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
    TextureLimits limits{};         ///< for Oversize::Smaller; otherwise the default

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
