#pragma once

#include "texplorer/base/result.h"
#include "texplorer/gl/environment.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/texture_levels.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace texplorer::reference {

/// A level as the sampler reads it. Extents exclude the border; the texels include it.
struct Level {
    int width = 0; ///< 0: the level does not exist
    int height = 1;
    int depth = 1;
    int border = 0;                  ///< 0 or 1 texel around the image, on the target's axes
    std::vector<glm::vec4> texels{}; ///< texture source colours, row 0 at t = 0
    /// The same in a quarter of the memory, for speed: the result of bytesOf, or empty.
    std::vector<std::int32_t> bytes{};

    [[nodiscard]] bool exists() const { return width > 0; }
    [[nodiscard]] glm::ivec3 size() const { return {width, height, depth}; }
};

/// A texture object with its images: all texture state of OpenGL 2.1, section 3.8.12. The border colour is a
/// texture source colour, like the texels; for a depth texture, red is the depth.
struct SampledTexture : SamplerState {
    Target target = Target::Texture2D;
    BaseFormat format = BaseFormat::Rgba; ///< defines what the environment does with a sample
    /// The format of the texels; for compressed textures, the one with their base format's name.
    InternalFormat internalFormat = InternalFormat::Rgba;
    std::vector<Level> levels{}; ///< the index is GL's level number; for a cube map: of the face +x
    std::vector<std::vector<Level>> otherFaces{}; ///< for a cube map: -x, +y, -y, +z, -z

    /// The level with this number, or nullptr. Faces as in CubeFace, counted from 0.
    [[nodiscard]] const Level* level(int number, int face = 0) const;
    /// Creates the level if it does not exist.
    [[nodiscard]] Level& levelToFill(int number, int face);
};

/// Tables 3.15 and 3.20: the components of a base internal format, expanded to a texture source colour.
/// Luminance is the image's red; missing components are 0, a missing alpha is 1.
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

/// Table 3.6: a pixel as RGBA, 0 to 1, before conversion to the internal format. A depth is a grey.
[[nodiscard]] glm::vec4 pixelColor(PixelFormat format, const std::byte* pixel);

/// Converts an image to a level: numbers of few bits to their values (section 2.14.9), sRGB colours to linear
/// light (EXT_texture_sRGB). An image with a border has `border` more texels on each side of the target's
/// axes.
[[nodiscard]] Level levelOf(const Image& image, InternalFormat format, Target target = Target::Texture2D,
                            int border = 0);

/// Returns each texel's four bytes if all components of all texels are multiples of 1/255; else an empty
/// list.
[[nodiscard]] std::vector<std::int32_t> bytesOf(std::span<const glm::vec4> texels);

/// Makes the texture object: the parameters of `texture` with prepared levels. What a driver would compress
/// is compressed by Texplorer's encoder, which a sentence in `notes` says. Errors: those of encodeBlocks.
[[nodiscard]] Result<SampledTexture> sampledTexture(const Texture& texture, const TextureLevels& levels,
                                                    Target target, std::vector<Sentence>& notes,
                                                    const std::stop_token& stop = {});

/// The same without parameters and texels: extents only, enough to check completeness.
[[nodiscard]] SampledTexture shapeOf(const TextureLevels& levels, Target target);

/// Sets the parameters only; `lastLevel` is that of TextureLevels.
void setParameters(SampledTexture& sampled, const SamplerState& given, int lastLevel);

} // namespace texplorer::reference
