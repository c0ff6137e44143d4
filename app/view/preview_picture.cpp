#include "app/view/preview_picture.h"

#include "texplorer/image/cube_faces.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/texture_levels.h"

#include <algorithm>
#include <array>

namespace texplorer::view {

namespace {

/// The settings that affect the base level. A flip of coordinates or of the matrix becomes a flip of pixels
/// here, because the panel shows the picture below the scene's coordinates.
Texture baseSettings(const Texture& texture) {
    Texture settings = imageSettings(texture);
    settings.flip = texture.flip == FlipMode::None ? FlipMode::None : FlipMode::Pixels;
    settings.compression = Compression::None;
    settings.compressedFormat = CompressedFormat::Dxt1;
    settings.compressionQuality = EncodeQuality::Normal;
    settings.mipmaps = MipPolicy::None;
    settings.levels.clear();
    settings.mipFilter = MipFilter::Box;
    settings.mipGamma = false;
    settings.mipCoverage = 0;
    const bool isPlain = factsOf(texture.internalFormat).encoding == Encoding::Linear &&
                         !isGenericCompressed(texture.internalFormat);
    if (!isPlain && !isRefused(texture.internalFormat)) // of a refused one nothing is shown
        settings.internalFormat = internalFormat(baseFormat(texture.internalFormat));
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

/// Whether it has more texels than a panel can show; the panel then gets a part of them.
bool isLarge(const TextureImage& image) {
    const Image* base = std::get_if<Image>(&image.surfaces.front());
    return base && base->depth == 1 && std::max(base->width, base->height) > PreviewPicture::maxTexels;
}

/// Every nth texel of a large image, as GL_NEAREST samples it when it is drawn small.
TextureImage thinned(const TextureImage& image) {
    const auto& base = std::get<Image>(image.surfaces.front());
    const int step =
        (std::max(base.width, base.height) + PreviewPicture::maxTexels - 1) / PreviewPicture::maxTexels;
    Image part =
        Image::uninitialised(base.format, (base.width + step - 1) / step, (base.height + step - 1) / step);
    for (int y = 0; y < part.height; ++y) {
        for (int x = 0; x < part.width; ++x)
            std::ranges::copy(base.at(x * step, y * step), part.at(x, y).begin());
    }
    TextureImage picture = textureOf(std::move(part), image.format);
    picture.topFirst = image.topFirst;
    picture.fileTopFirst = image.fileTopFirst;
    picture.alpha = image.alpha;
    return picture;
}

} // namespace

std::optional<LevelsRequest> PreviewPicture::request(const Texture& texture, const ImageSource& images) {
    TexturePictures pictures = images.picturesOf(texture);
    pictures.levels.clear();
    std::shared_ptr<const TextureImage>& image = pictures.base;
    if (!image)
        return std::nullopt;
    const bool isCube = image->faces == cubeFaceCount;
    if (!image->surfaces.empty() && (isCube || isLarge(*image))) {
        if (from_ != image) {
            from_ = image;
            shown_ = std::make_shared<const TextureImage>(isCube ? unfolded(*image) : thinned(*image));
        }
        image = shown_;
    }
    return LevelsRequest{std::move(pictures), baseSettings(texture), Target::Texture2D};
}

} // namespace texplorer::view
