#pragma once

#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/levels_source.h"

#include <memory>
#include <optional>

namespace texplorer::view {

/// The picture of a texture in a panel: its base level with its transparency and the bits of its internal
/// format as in the scene, but not compressed again; sRGB numbers as stored, so that it looks like the file;
/// upright, unless the scene flips nothing. A volume is shown by its middle slice, a file with six faces as
/// an unfolded cube. Does not need OpenGL.
class PreviewPicture {
public:
    /// The limit along each axis: a larger image is thinned to fit.
    static constexpr int maxTexels = 4096;

    /// The levels whose base is that picture; none if the image is not available. Keeps what it had to make.
    [[nodiscard]] std::optional<LevelsRequest> request(const Texture& texture, const ImageSource& images);

private:
    std::shared_ptr<const TextureImage> from_; ///< what shown_ was made of
    std::shared_ptr<const TextureImage> shown_;
};

} // namespace texplorer::view
