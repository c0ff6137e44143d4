#include "app/render/texture_preview.h"

#include "app/render/state_guard.h"
#include "core/scene/texture_levels.h"

#include <new>

namespace texplorer::render {

namespace {

/// What matters for the base level. A flip of coordinates or of the matrix is one of pixels here: the panel
/// shows the picture below the coordinates as the scene has them.
Texture baseSettings(const Texture& texture) {
    Texture settings = imageSettings(texture);
    settings.flip = texture.flip == FlipMode::None ? FlipMode::None : FlipMode::Pixels;
    settings.compression = Compression::None;
    settings.compressedFormat = CompressedFormat::Dxt1;
    settings.mipmaps = MipPolicy::None;
    settings.mipFilter = MipFilter::Box;
    settings.mipGamma = false;
    return settings;
}

} // namespace

unsigned TexturePreview::show(const Texture& texture, const ImageSource& images) {
    std::shared_ptr<const TextureImage> image = images.find(texture);
    if (!image)
        return 0;
    Texture settings = baseSettings(texture);
    if (image != image_ || settings != settings_) {
        image_ = std::move(image);
        settings_ = std::move(settings);
        object_ = TextureObject();
        GlErrors errors; // the renderer reports the same ones about the texture itself
        try {
            const Result<TextureLevels> levels = prepareLevels(settings_, *image_);
            if (!levels)
                return 0;
            const StateGuard guard;
            Texture plain;
            plain.magFilter = MagFilter::Nearest;
            plain.minFilter = MinFilter::Nearest;
            plain.wrapS = plain.wrapT = Wrap::ClampToEdge;
            TextureObject object(Target::Texture2D, settings_.internalFormat, *levels, "preview", errors);
            object.apply(plain, 1, "preview", errors);
            if (errors.sentences().empty())
                object_ = std::move(object);
        } catch (const std::bad_alloc&) {
            return 0;
        }
    }
    return object_.name();
}

} // namespace texplorer::render
