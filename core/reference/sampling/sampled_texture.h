#pragma once

#include "core/base/result.h"
#include "core/gl/environment.h"
#include "core/gl/sampling.h"
#include "core/image/image.h"
#include "core/scene/scene.h"
#include "core/texture/texture_levels.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace texplorer::reference {

/// One level as the sampler reads it. Extents are those without the border; the texels include it.
struct Level {
    int width = 0; ///< 0: there is no such level
    int height = 1;
    int depth = 1;
    int border = 0;                  ///< 0 or 1 texel around the image, on the axes that the target has
    std::vector<glm::vec4> texels{}; ///< texture source colours, row 0 at t = 0
    /// The same in a quarter of the memory, which is sooner read: what bytesOf gives, or nothing.
    std::vector<std::int32_t> bytes{};

    [[nodiscard]] bool exists() const { return width > 0; }
    [[nodiscard]] glm::ivec3 size() const { return {width, height, depth}; }
};

/// A texture object with its images: everything that OpenGL 2.1's section 3.8.12 calls texture state. The
/// border colour is a texture source colour, as the texels are; of a depth texture red is the depth.
struct SampledTexture : SamplerState {
    Target target = Target::Texture2D;
    BaseFormat format = BaseFormat::Rgba; ///< decides what the environment does with a sample
    /// What the texels were made of; of blocks the one that bears their base format's name.
    InternalFormat internalFormat = InternalFormat::Rgba;
    std::vector<Level> levels{}; ///< the index is GL's level number; of a cube map: of its face +x
    std::vector<std::vector<Level>> otherFaces{}; ///< of a cube map: -x, +y, -y, +z, -z

    /// The level with this number, or nullptr. Faces as in CubeFace, counted from 0.
    [[nodiscard]] const Level* level(int number, int face = 0) const;
    /// Makes room for it.
    [[nodiscard]] Level& levelToFill(int number, int face);
};

/// Table 3.15, then table 3.20: the components that a base internal format keeps of a colour, widened to the
/// four of the texture source colour. Luminance is the image's red; what a format lacks is 0, its alpha 1.
[[nodiscard]] constexpr glm::vec4 sourceColor(BaseFormat format, glm::vec4 rgba) {
    switch (format) {
    case BaseFormat::Alpha:
        return {0, 0, 0, rgba.a};
    case BaseFormat::Luminance:
        return {rgba.r, rgba.r, rgba.r, 1};
    case BaseFormat::LuminanceAlpha:
        return {rgba.r, rgba.r, rgba.r, rgba.a};
    case BaseFormat::Intensity:
        return {rgba.r, rgba.r, rgba.r, rgba.r};
    case BaseFormat::Rgb:
        return {rgba.r, rgba.g, rgba.b, 1};
    case BaseFormat::Rgba:
        return rgba;
    }
    return rgba;
}

/// Table 3.6: a pixel as RGBA, 0 to 1, before the internal format takes its part. A depth is a grey.
[[nodiscard]] glm::vec4 pixelColor(PixelFormat format, const std::byte* pixel);

/// An image as a level: numbers of few bits as what they stand for (section 2.14.9), colours of sRGB as
/// amounts of light (EXT_texture_sRGB). An image with a border has `border` texels more on each side of each
/// of the target's axes.
[[nodiscard]] Level levelOf(const Image& image, InternalFormat format, Target target = Target::Texture2D,
                            int border = 0);

/// Each texel's four bytes, if every component of all of them is a number of 255ths; else none.
[[nodiscard]] std::vector<std::int32_t> bytesOf(std::span<const glm::vec4> texels);

/// The texture object that GL would have: the parameters of `texture` over prepared levels. What a driver
/// would compress is compressed with Texplorer's own encoder, which a sentence in `notes` says. Errors: those
/// of encodeBlocks.
[[nodiscard]] Result<SampledTexture> sampledTexture(const Texture& texture, const TextureLevels& levels,
                                                    Target target, std::vector<std::string>& notes,
                                                    const std::stop_token& stop = {});

/// The same without parameters and without texels: the extents alone, enough to say whether a texture is
/// complete.
[[nodiscard]] SampledTexture shapeOf(const TextureLevels& levels, Target target);

/// The parameters alone; `lastLevel` is TextureLevels'.
void setParameters(SampledTexture& sampled, const SamplerState& given, int lastLevel);

} // namespace texplorer::reference
