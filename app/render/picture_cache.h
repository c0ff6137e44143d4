#pragma once

#include "app/render/gl_handle.h"
#include "texplorer/image/image.h"

#include <cstdint>
#include <map>
#include <memory>

namespace texplorer::render {

/// Textures of the pictures that panels show: uploaded at the first use, deleted when no longer shown. Works
/// with any OpenGL context, also a core profile. Belongs to the current context and its thread, and must be
/// destroyed before the context.
class PictureCache {
public:
    enum class Use {
        Scaled,   ///< to any size: filtered linearly
        Enlarged, ///< with visible pixels
    };

    /// A 2D texture of the image; none if GL refused it. Valid until `endFrame` has been called twice. Use an
    /// image always in the same way.
    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use = Use::Scaled);

    /// Deletes what was not shown since the last call.
    void endFrame();

private:
    struct Slot {
        TextureHandle texture;
        std::uint64_t frame = 0; ///< the last frame that showed it
    };
    std::map<std::shared_ptr<const Image>, Slot> slots_; // owns the images: an address identifies one
    std::uint64_t frame_ = 0;
};

} // namespace texplorer::render
