#pragma once

#include "core/scene/scene.h"
#include "core/texture/image_source.h"
#include "core/texture/levels_source.h"

#include <memory>
#include <optional>

namespace texplorer::render {

/// What of a texture a panel shows: its base level, its transparency and the bits of its internal format as
/// in the scene, not compressed again; numbers of sRGB as they are stored, so that it looks as the file does;
/// upright, unless the scene flips nothing. Of a volume the middle slice, of a file with six faces all of
/// them as an unfolded cube. Needs no OpenGL.
class PreviewPicture {
public:
    /// Along each axis: of a larger image as many are left out as are needed for this.
    static constexpr int mostTexels = 4096;

    /// The levels whose base is that picture; nothing where the image isn't there. Keeps what it had to make.
    [[nodiscard]] std::optional<LevelsRequest> request(const Texture& texture, const ImageSource& images);

private:
    std::shared_ptr<const TextureImage> from_; ///< what shown_ was made of
    std::shared_ptr<const TextureImage> shown_;
};

} // namespace texplorer::render
