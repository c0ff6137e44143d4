#pragma once

#include "app/view/pass_shader.h"
#include "app/view/picture_handle.h"
#include "app/view/size.h"
#include "app/view/stored_texture.h"
#include "texplorer/base/sentence.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/texture/image_source.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
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
    /// By texture of the scene and target: what the driver stores of the textures drawn.
    std::map<std::pair<std::size_t, Target>, std::shared_ptr<const StoredTexture>> stored{};
    /// What passes draw for textures that show it.
    std::map<PictureKey, std::shared_ptr<const TextureImage>> pictures{};
    std::uint64_t revision = 0; ///< of the picture: the same number, the same pixels as in the frame before
};

} // namespace texplorer::view
