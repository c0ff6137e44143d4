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
    settings.compressionQuality = EncodeQuality::Normal;
    settings.mipmaps = MipPolicy::None;
    settings.mipFilter = MipFilter::Box;
    settings.mipGamma = false;
    return settings;
}

} // namespace

unsigned TexturePreview::show(const Texture& texture, const ImageSource& images, LevelsSource* levels) {
    std::shared_ptr<const TextureImage> image = images.find(texture);
    if (!image)
        return 0;
    const LevelsRequest request{std::move(image), baseSettings(texture), Target::Texture2D};
    if (!live_.shows(request) || live_.isUploading()) {
        try {
            const StateGuard guard;
            live_.follow(request, nullptr, levels, "preview");
            Texture plain;
            plain.magFilter = MagFilter::Nearest;
            plain.minFilter = MinFilter::Nearest;
            plain.wrapS = plain.wrapT = Wrap::ClampToEdge;
            GlErrors errors;
            if (live_.object().name() != 0)
                live_.object().apply(plain, 1, "preview", errors);
        } catch (const std::bad_alloc&) {
            return 0;
        }
    }
    // The renderer reports the same errors about the texture itself.
    const bool usable = live_.isCancelled() || live_.errors().sentences().empty();
    return usable ? live_.object().name() : 0;
}

} // namespace texplorer::render
