#pragma once

#include "core/image/texture_image.h"
#include "core/scene/scene.h"

#include <memory>

namespace texplorer::ui {

/// Whether the picture of a texture's base level hides what is behind it. Remembers what it found in the last
/// image, whose texels it walks once.
class Opacity {
public:
    /// Never of one that is made transparent after it was read, nor of one in compressed blocks.
    [[nodiscard]] bool isOpaque(const Texture& texture, const std::shared_ptr<const TextureImage>& image);

private:
    std::shared_ptr<const TextureImage> image_;
    bool isOpaque_ = false;
};

} // namespace texplorer::ui
