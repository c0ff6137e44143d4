#include "app/render/texture_preview.h"

#include "app/render/state_guard.h"
#include "core/image/cube_faces.h"
#include "core/scene/texture_levels.h"

#include <array>
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

/// Six faces as one picture.
TextureImage unfolded(const TextureImage& image) {
    std::array<Image, cubeFaceCount> faces;
    for (int face = 0; face < cubeFaceCount; ++face) {
        Image& made = faces[static_cast<std::size_t>(face)];
        made = toImage(image.surface(face, 0));
        if (!image.topFirst)
            flipVertically(made);
    }
    TextureImage picture = textureOf(cubeCross(faces), image.format);
    picture.topFirst = true;
    return picture;
}

} // namespace

unsigned TexturePreview::show(const Texture& texture, const ImageSource& images, LevelsSource* levels) {
    std::shared_ptr<const TextureImage> image = images.find(texture);
    if (!image)
        return 0;
    if (image->faces == cubeFaceCount) {
        if (faces_ != image) {
            faces_ = image;
            unfolded_ = std::make_shared<const TextureImage>(unfolded(*image));
        }
        image = unfolded_;
    }
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
