#pragma once

#include "app/render/live_texture.h"
#include "app/view/preview_picture.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <memory>
#include <string>

namespace texplorer::render {

/// A view::PreviewPicture as a texture: internal format as in the scene, nearest filtering, edges clamped.
/// Belongs to the current context and its thread, and must be destroyed before the context.
class TexturePreview {
public:
    /// The name of a 2D texture, valid until the next call; 0 if the image is not available or GL refused it.
    /// Uploads only changes. With `levels` it may be the previous picture, or 0, until the new one is made
    /// and uploaded.
    [[nodiscard]] unsigned show(const Texture& texture, const ImageSource& images,
                                LevelsSource* levels = nullptr);

    /// Whether an upload continues in the next frame.
    [[nodiscard]] bool isUploading() const { return live_.isUploading(); }

private:
    LiveTexture live_;
    view::PreviewPicture picture_;
};

} // namespace texplorer::render
