#include "app/ui/texture_space/opacity.h"

#include <cstddef>
#include <variant>

namespace texplorer::ui {
namespace {

bool isOpaque(const Surface& surface) {
    const auto* image = std::get_if<Image>(&surface);
    if (!image)
        return false;
    const PixelFormat format = image->format;
    if (format != PixelFormat::Rgba8 && format != PixelFormat::LuminanceAlpha8)
        return format == PixelFormat::Rgb8 || format == PixelFormat::Luminance8;
    const auto step = static_cast<std::size_t>(bytesPerPixel(format));
    for (std::size_t alpha = step - 1; alpha < image->pixels.size(); alpha += step)
        if (image->pixels[alpha] != std::byte{255})
            return false;
    return true;
}

/// The alpha of the image is that of the texture.
bool keepsAlpha(const Texture& texture) {
    const BaseFormat base = baseFormat(texture.internalFormat);
    return texture.preparation.empty() &&
           (texture.transparency == Transparency::File || texture.transparency == Transparency::Solid ||
            texture.transparency == Transparency::Alpha) &&
           (base == BaseFormat::Rgb || base == BaseFormat::Rgba || base == BaseFormat::Luminance ||
            base == BaseFormat::LuminanceAlpha);
}

} // namespace

bool Opacity::isOpaque(const Texture& texture, const std::shared_ptr<const TextureImage>& image) {
    if (image_ != image) {
        image_ = image;
        isOpaque_ = image && !image->surfaces.empty() && ui::isOpaque(image->surfaces.front());
    }
    return isOpaque_ && keepsAlpha(texture);
}

} // namespace texplorer::ui
