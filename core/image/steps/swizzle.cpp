#include "texplorer/image/resample.h"
#include "texplorer/image/steps/image_steps.h"
#include "texplorer/image/steps/step_texels.h"

#include <algorithm>

namespace texplorer {
namespace {

using enum ComponentSource;

constexpr auto firstOfOther = static_cast<std::uint32_t>(OtherRed);

/// The same component, of the image that it is in.
ComponentSource withoutOther(ComponentSource source) {
    return isOfOther(source) ? static_cast<ComponentSource>(static_cast<std::uint32_t>(source) - firstOfOther)
                             : source;
}

/// An image of alpha alone has alpha for a luminance.
std::uint8_t valueOf(const Components& texel, ComponentSource source, bool colorless) {
    switch (source) {
    case Zero:
        return 0;
    case One:
        return 255;
    case Luminance:
        return colorless ? texel[3] : luminanceOf(texel);
    default:
        return texel[static_cast<std::size_t>(source)];
    }
}

/// A component of another image as a grey one of this one's size: its luminance is scaled, not its colours.
Image planeOf(const Image& other, ComponentSource source, const Image& size) {
    const bool colorless = other.format == PixelFormat::Alpha8;
    const Image plane = eachTexel(other, PixelFormat::Luminance8, [=](const Components& texel, std::size_t) {
        return Components{valueOf(texel, withoutOther(source), colorless)};
    });
    return scaleByCoverage(plane, size.width, size.height, size.depth);
}

/// The smallest format that holds the result, whatever the texels are.
PixelFormat formatOf(PixelFormat format, const std::array<ComponentSource, 4>& sources) {
    const bool colorless = format == PixelFormat::Alpha8;
    const auto isColorOfGrey = [&](ComponentSource source) {
        return source <= Blue || (source == Luminance && !colorless);
    };
    const auto isBlack = [&](ComponentSource source) {
        return source == Zero || (colorless && source <= Blue);
    };
    const auto colors = std::span(sources).first(3);
    const bool alike = std::ranges::all_of(colors, [&](ComponentSource each) { return each == colors[0]; });
    const bool grey = alike || std::ranges::all_of(colors, isBlack) ||
                      (isGrey(format) && std::ranges::all_of(colors, isColorOfGrey));
    const bool opaque = sources[3] == One || (sources[3] == Alpha && alphaComponent(format) < 0);
    if (!opaque && std::ranges::all_of(colors, isBlack))
        return PixelFormat::Alpha8;
    return smallestFormat(grey, !opaque);
}

} // namespace

Image swizzled(const Image& image, const std::array<ComponentSource, 4>& sources, const Image* other) {
    std::array<Image, 4> planes;
    for (std::size_t i = 0; i < 4; ++i) {
        if (!isOfOther(sources[i]))
            continue;
        if (!other || other->empty())
            return image;
        const auto same =
            std::find(sources.begin(), sources.begin() + static_cast<std::ptrdiff_t>(i), sources[i]);
        const auto known = static_cast<std::size_t>(same - sources.begin());
        planes[i] = known < i ? planes[known] : planeOf(*other, sources[i], image);
    }
    const bool colorless = image.format == PixelFormat::Alpha8;
    return eachTexel(image, formatOf(image.format, sources), [&](const Components& texel, std::size_t at) {
        Components made{};
        for (std::size_t i = 0; i < 4; ++i)
            made[i] = planes[i].empty() ? valueOf(texel, sources[i], colorless)
                                        : std::to_integer<std::uint8_t>(planes[i].pixels[at]);
        return made;
    });
}

} // namespace texplorer
