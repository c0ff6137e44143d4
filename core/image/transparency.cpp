#include "texplorer/image/transparency.h"

#include <algorithm>
#include <cmath>

namespace texplorer {

namespace {

struct Rgb {
    int r;
    int g;
    int b;

    [[nodiscard]] int sum() const { return r + g + b; }
    [[nodiscard]] int squares() const { return r * r + g * g + b * b; }
};

bool hasAlpha(PixelFormat format) {
    return format == PixelFormat::Rgba8 || format == PixelFormat::LuminanceAlpha8;
}

std::size_t colorBytes(PixelFormat format) {
    return format == PixelFormat::Rgb8 || format == PixelFormat::Rgba8 ? 3 : 1;
}

Image withAlphaPlace(Image image) {
    if (hasAlpha(image.format))
        return image;
    Image wider = Image::uninitialised(colorBytes(image.format) == 3 ? PixelFormat::Rgba8
                                                                     : PixelFormat::LuminanceAlpha8,
                                       image.width, image.height, image.depth);
    const std::size_t colors = colorBytes(image.format);
    std::byte* to = wider.pixels.data();
    const std::byte* end = image.pixels.data() + image.pixels.size();
    for (const std::byte* from = image.pixels.data(); from != end; from += colors, to += colors + 1)
        std::copy_n(from, colors, to);
    return wider;
}

// In place: what is written never overtakes what is read.
Image withoutAlphaPlace(Image image) {
    if (!hasAlpha(image.format))
        return image;
    const std::size_t colors = colorBytes(image.format);
    std::byte* to = image.pixels.data();
    const std::byte* end = to + image.pixels.size();
    for (const std::byte* from = to; from != end; from += colors + 1, to += colors)
        for (std::size_t i = 0; i < colors; ++i)
            to[i] = from[i];
    image.format = colors == 3 ? PixelFormat::Rgb8 : PixelFormat::Luminance8;
    image.pixels.resize(image.pixels.size() / (colors + 1) * colors);
    return image;
}

// `formula` gives an alpha of 0 or more; what is above 255 is 255.
template<class Formula>
Image alphaFromColor(Image source, Formula formula) {
    Image image = withAlphaPlace(std::move(source));
    const std::size_t colors = colorBytes(image.format);
    const auto component = [](std::byte value) { return std::to_integer<int>(value); };
    const std::byte* end = image.pixels.data() + image.pixels.size();
    for (std::byte* at = image.pixels.data(); at != end; at += colors + 1) {
        const int red = component(at[0]);
        const Rgb color = colors == 3 ? Rgb{red, component(at[1]), component(at[2])} : Rgb{red, red, red};
        at[colors] = static_cast<std::byte>(std::min(formula(color), 255));
    }
    return image;
}

} // namespace

Image applyTransparency(Image image, Transparency choice, std::array<std::uint8_t, 3> stencil) {
    if (image.format == PixelFormat::Alpha8)
        return image;
    switch (choice) {
    case Transparency::File:
        return image;
    case Transparency::Solid:
        return withoutAlphaPlace(std::move(image));
    case Transparency::Alpha:
        return hasAlpha(image.format) ? std::move(image)
                                      : alphaFromColor(std::move(image), [](Rgb) { return 255; });
    case Transparency::Stencil:
        return alphaFromColor(std::move(image), [stencil](Rgb c) {
            return c.r == stencil[0] && c.g == stencil[1] && c.b == stencil[2] ? 0 : 255;
        });
    case Transparency::Blend1:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.sum(); });
    case Transparency::Blend2:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.sum() / 2; });
    case Transparency::Blend3:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.sum() / 3; });
    case Transparency::Blend4:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.squares(); });
    case Transparency::Blend5:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.squares() / 2; });
    case Transparency::Blend6:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.squares() / 3; });
    case Transparency::Blend7:
        return alphaFromColor(std::move(image), [](Rgb c) { return c.squares() / 4; });
    case Transparency::Blend8:
        return alphaFromColor(std::move(image), [](Rgb c) {
            return static_cast<int>(std::sqrt(static_cast<double>(c.squares())));
        });
    }
    return image;
}

} // namespace texplorer
