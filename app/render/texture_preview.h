#pragma once

#include "app/render/live_texture.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <memory>
#include <string>

namespace texplorer::render {

/// A texture's base level as a picture in a panel: its internal format and transparency as in the scene, not
/// compressed again, nearest filtering, edges clamped; upright, unless the scene flips nothing. Belongs to
/// the context that is current, on its thread, and must be destroyed before that.
class TexturePreview {
public:
    /// Along each axis: of a larger image as many are left out as are needed for this.
    static constexpr int mostTexels = 4096;

    /// The name of a 2D texture that stays valid until the next call; 0 where the image isn't there or GL
    /// refused it. Uploads only what changed. Of a volume it shows the middle slice, of a file with six faces
    /// all of them as an unfolded cube.
    /// With `levels` it may be the picture of before, or 0, until it is made and uploaded.
    [[nodiscard]] unsigned show(const Texture& texture, const ImageSource& images,
                                LevelsSource* levels = nullptr);

    /// Whether an upload has to go on with the next frame.
    [[nodiscard]] bool isUploading() const { return live_.isUploading(); }

private:
    LiveTexture live_;
    std::shared_ptr<const TextureImage> from_; ///< what shown_ was made of
    std::shared_ptr<const TextureImage> shown_;
};

} // namespace texplorer::render
