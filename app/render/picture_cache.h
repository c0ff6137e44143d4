#pragma once

#include "app/render/gl_handle.h"
#include "core/image/image.h"

#include <cstdint>
#include <map>
#include <memory>

namespace texplorer::render {

/// Textures of the pictures that panels show: uploaded when a picture is first shown, gone when it no
/// longer is. Any context of OpenGL will do, a core profile too. Belongs to the context that is current, on
/// its thread, and must be destroyed before that.
class PictureCache {
public:
    enum class Use {
        Scaled,   ///< to any size: filtered linearly
        Enlarged, ///< so that one sees its pixels
    };

    /// A 2D texture of the image; none where GL refused it. Stays valid until the second `endFrame` from
    /// here. An image is used in one way.
    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use = Use::Scaled);

    /// Forgets what was not shown since the last call.
    void endFrame();

private:
    struct Slot {
        TextureHandle texture;
        std::uint64_t frame = 0; ///< in which it was shown last
    };
    std::map<std::shared_ptr<const Image>, Slot> slots_; // holds the images: an address stands for one
    std::uint64_t frame_ = 0;
};

} // namespace texplorer::render
