#pragma once

#include "texplorer/image/texture_image.h"
#include "texplorer/scene/scene.h"

#include <memory>

namespace texplorer::ui {

/// Whether the picture of a texture's base level is opaque. Caches the result for the last image, whose
/// texels it checks once.
class Opacity {
public:
    /// Always false if transparency is added after reading, and for compressed blocks.
    [[nodiscard]] bool isOpaque(const Texture& texture, const std::shared_ptr<const TextureImage>& image);

private:
    std::shared_ptr<const TextureImage> image_;
    bool isOpaque_ = false;
};

} // namespace texplorer::ui
