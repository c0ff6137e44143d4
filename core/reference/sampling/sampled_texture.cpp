#include "texplorer/reference/sampling/sampled_texture.h"

#include "texplorer/image/convert.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/float_pixels.h"
#include "texplorer/image/linear_light.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/image/stored_numbers.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/encode.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace texplorer::reference {

namespace {

using Values = std::array<float, 256>;

/// What each byte of a component stands for, once it is stored.
Values valuesOf(const FormatFacts& facts, std::size_t component) {
    if (facts.encoding == Encoding::Srgb && component < 3)
        return LinearLight::table().exactLight;
    const int bits = facts.bits.at(component) == 0 ? 8 : std::min<int>(facts.bits.at(component), 8);
    const auto max = static_cast<float>(maxNumber(bits));
    Values values{};
    for (std::size_t byte = 0; byte < values.size(); ++byte)
        values[byte] = static_cast<float>(storedNumber(static_cast<int>(byte), bits)) / max;
    return values;
}

Level blockLevel(const BlockImage& blocks) {
    Level level = levelOf(decodeBlocks(blocks), internalFormat(baseFormat(blocks.format)));
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

void setFormat(SampledTexture& sampled, const TextureLevels& levels) {
    const BlockImage* blocks =
        levels.levels.empty() ? nullptr : std::get_if<BlockImage>(&*levels.levels.front().surface);
    sampled.internalFormat = levels.driverFormat ? internalFormat(baseFormat(*levels.driverFormat))
                             : blocks            ? internalFormat(baseFormat(blocks->format))
                                                 : levels.internalFormat;
    sampled.format = baseFormat(sampled.internalFormat);
}

} // namespace

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
    if (format == PixelFormat::Depth32)
        return {glm::vec3(static_cast<float>(depthAt(pixel) / double{farthestDepth32})), 1};
    if (format == PixelFormat::RgbaFloat) {
        const FloatTexel texel = floatsAt(pixel);
        return {texel[0], texel[1], texel[2], texel[3]};
    }
    const auto rgba = rgbaOf(format, pixel);
    return glm::vec4(rgba[0], rgba[1], rgba[2], rgba[3]) / 255.0F;
}

Level levelOf(const Image& image, InternalFormat format, Target target, int border) {
    assert(border == 0 || border == 1);
    const int axes = axesOf(target);
    Level level;
    level.border = border;
    level.width = image.width - 2 * border;
    level.height = axes > 1 ? image.height - 2 * border : image.height;
    level.depth = axes > 2 ? image.depth - 2 * border : image.depth;
    level.texels.resize(image.pixels.size() / static_cast<std::size_t>(bytesPerPixel(image.format)));
    if (image.format == PixelFormat::Depth32) { // as many bits as the format has, by now
        for (std::size_t i = 0; i < level.texels.size(); ++i)
            level.texels[i] = pixelColor(image.format, image.pixels.data() + i * sizeof(std::uint32_t));
        return level;
    }
    const FormatFacts& facts = factsOf(format);
    if (image.format == PixelFormat::RgbaFloat) {
        for (std::size_t i = 0; i < level.texels.size(); ++i)
            level.texels[i] = sourceColor(
                facts.base, pixelColor(image.format, image.pixels.data() + i * sizeof(FloatTexel)));
        return level;
    }
    const std::array values{valuesOf(facts, 0), valuesOf(facts, 1), valuesOf(facts, 2), valuesOf(facts, 3)};
    const std::byte* pixel = image.pixels.data();
    for (glm::vec4& texel : level.texels) {
        const auto rgba = rgbaOf(image.format, pixel);
        texel = sourceColor(facts.base,
                            {values[0][rgba[0]], values[1][rgba[1]], values[2][rgba[2]], values[3][rgba[3]]});
        pixel += bytesPerPixel(image.format);
    }
    return level;
}

std::vector<std::int32_t> bytesOf(std::span<const glm::vec4> texels) {
    std::vector<std::int32_t> bytes(texels.size());
    constexpr std::size_t block = 1024; // texels: the compiler vectorises a loop without another end
    for (std::size_t first = 0; first < texels.size(); first += block) {
        const std::size_t count = 4 * std::min(block, texels.size() - first);
        const float* const values = &texels[first].x;
        auto* const numbers = reinterpret_cast<std::uint8_t*>(&bytes[first]);
        int others = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const float value = values[i];
            const auto number = static_cast<int>(value >= 0 && value <= 1 ? value * 255 + 0.5F : 0);
            others |= value != static_cast<float>(number) / 255 ? 1 : 0;
            numbers[i] = static_cast<std::uint8_t>(number);
        }
        if (others != 0)
            return {};
    }
    return bytes;
}

Result<SampledTexture> sampledTexture(const Texture& texture, const TextureLevels& levels, Target target,
                                      std::vector<Sentence>& notes, const std::stop_token& stop) {
    SampledTexture sampled;
    sampled.target = target;
    setFormat(sampled, levels);
    for (const TextureLevel& each : levels.levels) {
        Level& level = sampled.levelToFill(each.number, each.face);
        const auto* blocks = std::get_if<BlockImage>(&*each.surface);
        if (blocks) {
            level = blockLevel(*blocks);
            continue;
        }
        const Image& image = std::get<Image>(*each.surface);
        if (!levels.driverFormat) {
            level = levelOf(image, sampled.internalFormat, target, levels.border);
            continue;
        }
        const Result<BlockImage> encoded =
            encodeBlocks(image, *levels.driverFormat, EncodeQuality::Fast, {}, stop);
        if (!encoded)
            return fail(encoded.error());
        level = blockLevel(*encoded);
    }
    if (target == Target::Texture2D) {
        for (Level& level : sampled.levels)
            level.bytes = bytesOf(level.texels);
    }
    if (levels.driverFormat)
        notes.push_back(Sentence("drivers compress differently: compressed to {0} by Texplorer's encoder",
                                 ProperName{rowOf(*levels.driverFormat).name}));
    if (isGenericCompressed(sampled.internalFormat))
        notes.push_back(Sentence("drivers choose what {0} is stored as: drawn without compression",
                                 ProperName{rowOf(sampled.internalFormat).name}));
    const auto isOdd = [](const Level& level) {
        return !arePowersOfTwo(level.width, level.height, level.depth);
    };
    if (levels.madeByDriver && wantsMipmaps(texture.minFilter) && std::ranges::any_of(sampled.levels, isOdd))
        notes.push_back(
            Sentence("drivers halve odd sizes differently: levels made with Texplorer's box filter"));
    setParameters(sampled, texture, levels.lastLevel);
    return sampled;
}

SampledTexture shapeOf(const TextureLevels& levels, Target target) {
    SampledTexture shape;
    shape.target = target;
    setFormat(shape, levels);
    for (const TextureLevel& level : levels.levels) {
        const int both = 2 * levels.border;
        const Surface& surface = level.surface;
        shape.levelToFill(level.number,
                          level.face) = {.width = widthOf(surface) - both,
                                         .height = heightOf(surface) - (axesOf(target) > 1 ? both : 0),
                                         .depth = depthOf(surface) - (axesOf(target) > 2 ? both : 0),
                                         .border = levels.border};
    }
    return shape;
}

void setParameters(SampledTexture& sampled, const SamplerState& given, int lastLevel) {
    static_cast<SamplerState&>(sampled) = given;
    // Section 3.8.4: the border colour is clamped to [0, 1] when it is given. Of depths its red counts.
    const glm::vec4 border = glm::clamp(given.borderColor, 0.0F, 1.0F);
    sampled.borderColor = sourceColor(sampled.format, border);
    if (isDepth(sampled.internalFormat)) {
        sampled.borderColor = glm::vec4(border.r);
        sampled.format = baseFormat(given.depthMode);
    }
    sampled.maxLevel = std::min(given.maxLevel, lastLevel);
}

} // namespace texplorer::reference
