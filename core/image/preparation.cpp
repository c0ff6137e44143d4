#include "texplorer/image/preparation.h"

#include "texplorer/image/linear_light.h"
#include "texplorer/image/resample.h"
#include "texplorer/image/steps/image_steps.h"
#include "texplorer/image/steps/step_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace texplorer {

namespace {

std::uint8_t valueOf(std::byte byte) {
    return std::to_integer<std::uint8_t>(byte);
}

/// A component of 8 bits, scaled and biased: in the order and precision in which Mesa does it, so that what
/// lies half way between two values is rounded alike.
std::uint8_t transferredValue(std::uint8_t value, float factor, float bias) {
    const float scaled = static_cast<float>(value) * (1.0F / 255.0F) * factor;
    return static_cast<std::uint8_t>(std::nearbyint(255.0F * std::clamp(scaled + bias, 0.0F, 1.0F)));
}

Image transferred(const Image& image, const glm::vec4& factor, const glm::vec4& bias) {
    using Table = std::array<std::uint8_t, 256>;
    std::array<Table, 4> tables;
    for (int component = 0; component < 4; ++component)
        for (int value = 0; value < 256; ++value)
            tables[static_cast<std::size_t>(component)][static_cast<std::size_t>(value)] =
                transferredValue(static_cast<std::uint8_t>(value), factor[component], bias[component]);
    const auto alike = [&](std::size_t value) {
        return tables[0][value] == tables[1][value] && tables[0][value] == tables[2][value];
    };
    const bool colorless = image.format == PixelFormat::Alpha8;
    const bool isBlack = colorless && alike(0) && tables[0][0] == 0;
    const bool grey =
        colorless ? alike(0) : isGrey(image.format) && tables[0] == tables[1] && tables[0] == tables[2];
    const bool alpha = alphaComponent(image.format) >= 0 || tables[3][255] != 255;
    const auto change = [&](Components color, std::size_t) {
        for (std::size_t i = 0; i < 4; ++i)
            color[i] = tables[i][color[i]];
        return color;
    };
    return eachTexel(image, isBlack ? PixelFormat::Alpha8 : smallestFormat(grey, alpha), change);
}

Image inverted(Image image) {
    const int alpha = alphaComponent(image.format);
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (static_cast<int>(i % step) != alpha)
            image.pixels[i] = ~image.pixels[i];
    }
    return image;
}

Image premultiplied(const Image& image) {
    if (alphaComponent(image.format) < 0)
        return image;
    return eachTexel(image, image.format, [](Components color, std::size_t) {
        for (std::size_t i = 0; i < 3; ++i)
            color[i] = static_cast<std::uint8_t>((color[i] * color[3] + 127) / 255);
        return color;
    });
}

Image sharpened(const Image& image, float amount) {
    Image made = image;
    const auto components = static_cast<std::size_t>(bytesPerPixel(image.format));
    const int alpha = alphaComponent(image.format);
    const std::size_t length = static_cast<std::size_t>(image.width) * components;
    std::vector<int> sums(length); // of three rows, so that a texel adds up three columns
    const auto rowAt = [&image](int y, int z) {
        return image.at(0, std::clamp(y, 0, image.height - 1), z).data();
    };
    const auto sharpenRow = [&](int y, int z) {
        const std::array rows{rowAt(y - 1, z), rowAt(y, z), rowAt(y + 1, z)};
        for (std::size_t i = 0; i < length; ++i)
            sums[i] = valueOf(rows[0][i]) + valueOf(rows[1][i]) + valueOf(rows[2][i]);
        std::byte* const row = made.at(0, y, z).data();
        for (std::size_t i = 0; i < length; ++i) {
            if (static_cast<int>(i % components) == alpha)
                continue;
            const std::size_t left = i < components ? i : i - components;
            const std::size_t right = i + components < length ? i + components : i;
            const int value = valueOf(rows[1][i]);
            const double away = (9 * value - sums[left] - sums[i] - sums[right]) / 8.0; // they have it, too
            const double moved = std::clamp(value + double{amount} * away, 0.0, 255.0);
            row[i] = static_cast<std::byte>(std::lround(moved));
        }
    };
    for (int z = 0; z < image.depth; ++z)
        for (int y = 0; y < image.height; ++y)
            sharpenRow(y, z);
    return made;
}

} // namespace

Image prepared(Image image, const Operation& operation) {
    const bool colorless = image.format == PixelFormat::Alpha8;
    if (image.empty() || image.format == PixelFormat::Depth32)
        return image;
    using enum ComponentSource;
    switch (operation.op) {
    case ImageOp::Scale:
        return transferred(image, operation.factor, operation.bias);
    case ImageOp::AlphaFrom:
        return swizzled(image, {Red, Green, Blue, OtherLuminance}, operation.other);
    case ImageOp::Swizzle:
        return swizzled(image, operation.components, operation.other);
    case ImageOp::Resize:
        return scaleByCoverage(image, operation.extent[0], operation.extent[1], operation.extent[2]);
    case ImageOp::Invert:
        return colorless ? image : inverted(std::move(image));
    case ImageOp::Luminance:
        return colorless ? image : swizzled(image, {Luminance, Luminance, Luminance, Alpha});
    case ImageOp::LuminanceToAlpha:
        return colorless ? image : swizzled(image, {Red, Green, Blue, Luminance});
    case ImageOp::Premultiply:
        return colorless ? image : premultiplied(image);
    case ImageOp::Spread:
        return withColorsSpread(std::move(image));
    case ImageOp::Sharpen:
        return colorless ? image : sharpened(image, operation.amount);
    case ImageOp::Normals:
        return colorless ? image : normalsOf(image, operation.amount, operation.topFirst);
    }
    return image;
}

} // namespace texplorer
