#pragma once

#include "app/view/pass_shader.h"
#include "app/view/picture_handle.h"
#include "app/view/size.h"
#include "texplorer/base/sentence.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace texplorer::view {

/// What a renderer hands to a view: the picture, of exactly `size` pixels, bottom row first, owned by the
/// renderer and valid until it draws again.
struct Frame {
    PictureHandle picture = PictureHandle::None; ///< of nothing where nothing could be drawn
    Size size;
    double milliseconds = 0;        ///< wall time of the draw call, without waiting for the GPU
    std::vector<Sentence> problems; ///< sentences: GL errors named with their call, textures that are missing
    bool unfinished = false;        ///< textures are still being uploaded: draw again
    /// Of each pass, where shaders draw it; see core/glsl/shader_source.h. nullptr: there is none.
    std::vector<std::shared_ptr<const PassShader>> shaders{};
    std::uint64_t revision = 0; ///< of the picture: the same number, the same pixels as in the frame before
};

} // namespace texplorer::view
