#include "core/reference/sampling/sampled_texture.h"

#include "core/s3tc/decode.h"
#include "core/s3tc/encode.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cassert>

namespace texplorer::reference {

namespace {

float unorm(std::byte value) {
    return static_cast<float>(std::to_integer<int>(value)) / 255.0F;
}

Level blockLevel(const BlockImage& blocks) {
    Level level = levelOf(decodeBlocks(blocks), baseFormat(blocks.format));
    if (isS3tc(blocks.format))
        return level;
    const bool isSigned = blocks.format == BlockFormat::Bc4Signed || blocks.format == BlockFormat::Bc5Signed;
    const bool hasGreen = blocks.format == BlockFormat::Bc5 || blocks.format == BlockFormat::Bc5Signed;
    for (glm::vec4& texel : level.texels) {
        if (isSigned)
            texel = texel * 2.0F - 1.0F;
        texel = {texel.r, hasGreen ? texel.g : 0, 0, 1};
    }
    return level;
}

} // namespace

BaseFormat baseFormat(BlockFormat format) {
    return isS3tc(format) && format != BlockFormat::Dxt1 ? BaseFormat::Rgba : BaseFormat::Rgb;
}

const Level* SampledTexture::level(int number, int face) const {
    const auto other = static_cast<std::size_t>(face) - 1;
    if (face != 0 && other >= otherFaces.size())
        return nullptr;
    const std::vector<Level>& all = face == 0 ? levels : otherFaces[other];
    if (number < 0 || static_cast<std::size_t>(number) >= all.size())
        return nullptr;
    const Level& found = all[static_cast<std::size_t>(number)];
    return found.exists() ? &found : nullptr;
}

Level& SampledTexture::levelToFill(int number, int face) {
    const auto other = static_cast<std::size_t>(face) - 1;
    if (face != 0 && other >= otherFaces.size())
        otherFaces.resize(other + 1);
    std::vector<Level>& all = face == 0 ? levels : otherFaces[other];
    const auto at = static_cast<std::size_t>(number);
    if (at >= all.size())
        all.resize(at + 1);
    return all[at];
}

glm::vec4 pixelColor(PixelFormat format, const std::byte* pixel) {
    switch (format) {
    case PixelFormat::Alpha8:
        return {0, 0, 0, unorm(pixel[0])};
    case PixelFormat::Luminance8:
        return {glm::vec3(unorm(pixel[0])), 1};
    case PixelFormat::LuminanceAlpha8:
        return {glm::vec3(unorm(pixel[0])), unorm(pixel[1])};
    case PixelFormat::Rgb8:
        return {unorm(pixel[0]), unorm(pixel[1]), unorm(pixel[2]), 1};
    case PixelFormat::Rgba8:
        return {unorm(pixel[0]), unorm(pixel[1]), unorm(pixel[2]), unorm(pixel[3])};
    }
    return {};
}

Level levelOf(const Image& image, BaseFormat format, Target target, int border) {
    assert(border == 0 || border == 1);
    const int axes = axesOf(target);
    Level level;
    level.border = border;
    level.width = image.width - 2 * border;
    level.height = axes > 1 ? image.height - 2 * border : image.height;
    level.depth = axes > 2 ? image.depth - 2 * border : image.depth;
    level.texels.resize(image.pixels.size() / static_cast<std::size_t>(bytesPerPixel(image.format)));
    const std::byte* pixel = image.pixels.data();
    for (glm::vec4& texel : level.texels) {
        texel = sourceColor(format, pixelColor(image.format, pixel));
        pixel += bytesPerPixel(image.format);
    }
    return level;
}

Result<SampledTexture> sampledTexture(const Texture& texture, const TextureLevels& levels, Target target,
                                      std::vector<std::string>& notes, const std::stop_token& stop) {
    SampledTexture sampled;
    sampled.target = target;
    sampled.format = baseFormat(texture.internalFormat);
    for (const TextureLevel& each : levels.levels) {
        Level& level = sampled.levelToFill(each.number, each.face);
        const auto* blocks = std::get_if<BlockImage>(&*each.surface);
        if (blocks) {
            sampled.format = baseFormat(blocks->format);
            level = blockLevel(*blocks);
            continue;
        }
        const Image& image = std::get<Image>(*each.surface);
        if (!levels.driverFormat) {
            level = levelOf(image, baseFormat(texture.internalFormat), target, levels.border);
            continue;
        }
        const Result<BlockImage> encoded =
            encodeBlocks(image, *levels.driverFormat, EncodeQuality::Fast, {}, stop);
        if (!encoded)
            return fail(encoded.error());
        sampled.format = baseFormat(encoded->format);
        level = blockLevel(*encoded);
    }
    if (levels.driverFormat)
        notes.push_back(fmt::format(
            "what a driver compresses to is its own affair: compressed to {} by Texplorer's encoder",
            rowOf(*levels.driverFormat).name));
    setParameters(sampled, texture, levels.lastLevel);
    return sampled;
}

SampledTexture shapeOf(const TextureLevels& levels, InternalFormat internalFormat, Target target) {
    SampledTexture shape;
    shape.target = target;
    shape.format = levels.driverFormat ? baseFormat(*levels.driverFormat) : baseFormat(internalFormat);
    for (const auto& [number, surface, face] : levels.levels) {
        const int both = 2 * levels.border;
        shape.levelToFill(number, face) = {.width = widthOf(surface) - both,
                                           .height = heightOf(surface) - (axesOf(target) > 1 ? both : 0),
                                           .depth = depthOf(surface) - (axesOf(target) > 2 ? both : 0),
                                           .border = levels.border};
        if (const auto* blocks = std::get_if<BlockImage>(&*surface))
            shape.format = baseFormat(blocks->format);
    }
    return shape;
}

void setParameters(SampledTexture& sampled, const SamplerState& given, int lastLevel) {
    static_cast<SamplerState&>(sampled) = given;
    // Section 3.8.4: the border colour is clamped to [0, 1] when it is given.
    sampled.borderColor = sourceColor(sampled.format, glm::clamp(given.borderColor, 0.0F, 1.0F));
    sampled.maxLevel = std::min(given.maxLevel, lastLevel);
}

} // namespace texplorer::reference
