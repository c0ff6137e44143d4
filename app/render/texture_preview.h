#pragma once

#include "app/render/live_texture.h"
#include "app/render/preview_picture.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <memory>
#include <string>

namespace texplorer::render {

/// A PreviewPicture as a texture: its internal format as in the scene, nearest filtering, edges clamped.
/// Belongs to the context that is current, on its thread, and must be destroyed before that.
class TexturePreview {
public:
    /// The name of a 2D texture that stays valid until the next call; 0 where the image isn't there or GL
    /// refused it. Uploads only what changed.
    /// With `levels` it may be the picture of before, or 0, until it is made and uploaded.
    [[nodiscard]] unsigned show(const Texture& texture, const ImageSource& images,
                                LevelsSource* levels = nullptr);

    /// Whether an upload has to go on with the next frame.
    [[nodiscard]] bool isUploading() const { return live_.isUploading(); }

private:
    LiveTexture live_;
    PreviewPicture picture_;
};

} // namespace texplorer::render
