#pragma once

// The sampling parameters of a texture object: OpenGL 2.1, section 3.8.4, table 3.18.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class MagFilter : std::uint32_t { Nearest = 0x2600, Linear = 0x2601 };

enum class MinFilter : std::uint32_t {
    Nearest = 0x2600,
    Linear = 0x2601,
    NearestMipmapNearest = 0x2700,
    LinearMipmapNearest = 0x2701,
    NearestMipmapLinear = 0x2702,
    LinearMipmapLinear = 0x2703,
};

enum class Wrap : std::uint32_t {
    Repeat = 0x2901,
    MirroredRepeat = 0x8370,
    ClampToEdge = 0x812F,
    ClampToBorder = 0x812D,
    Clamp = 0x2900,
};

enum class Target : std::uint32_t {
    Texture1D = 0x0DE0,
    Texture2D = 0x0DE1,
    Texture3D = 0x806F,
    CubeMap = 0x8513,
};

/// The images of a cube map, in OpenGL's order.
enum class CubeFace : std::uint32_t {
    PositiveX = 0x8515,
    NegativeX = 0x8516,
    PositiveY = 0x8517,
    NegativeY = 0x8518,
    PositiveZ = 0x8519,
    NegativeZ = 0x851A,
};

/// The number of axes of a target's images.
[[nodiscard]] constexpr int axesOf(Target target) {
    return target == Target::Texture1D ? 1 : target == Target::Texture3D ? 3 : 2;
}

/// The number of coordinates (s, t, r) that a target uses.
[[nodiscard]] constexpr int coordinatesOf(Target target) {
    return target == Target::CubeMap ? 3 : axesOf(target);
}

/// The number of images per level.
[[nodiscard]] constexpr int facesOf(Target target) {
    return target == Target::CubeMap ? 6 : 1;
}

/// Counted from 0.
[[nodiscard]] constexpr CubeFace cubeFaceAt(int index) {
    return static_cast<CubeFace>(static_cast<std::uint32_t>(CubeFace::PositiveX) +
                                 static_cast<std::uint32_t>(index));
}

inline constexpr std::array magFilterRows{
    row(MagFilter::Nearest, "GL_NEAREST", "Nearest",
        "Reads the one texel that contains the sample. Hard edges, visible blocks.", "1.0"),
    row(MagFilter::Linear, "GL_LINEAR", "Linear",
        "Blends the 2 × 2 texels around the sample by distance. Smooth, slightly blurred.", "1.0"),
};

/// With button labels: a line for each way to use the levels.
constexpr EnumRow minFilterRow(MinFilter value, std::string_view name, std::string_view label,
                               std::string_view help, std::string_view levels, std::string_view brief = {}) {
    return {static_cast<std::uint32_t>(value), name, label, help, "1.0", levels, brief};
}

inline constexpr std::array minFilterRows{
    minFilterRow(MinFilter::Nearest, "GL_NEAREST", "Nearest",
                 N_("One texel of the base level, however many the pixel covers. Shimmers and aliases."),
                 N_("No mipmaps")),
    minFilterRow(
        MinFilter::Linear, "GL_LINEAR", "Linear",
        N_("2 × 2 texels of the base level. Still aliases where a pixel covers more than two texels."),
        N_("No mipmaps")),
    minFilterRow(MinFilter::NearestMipmapNearest, "GL_NEAREST_MIPMAP_NEAREST", N_("Nearest, nearest mip"),
                 N_("One texel of the one mip level that fits the pixel best."), N_("Nearest mip"),
                 "Nearest"),
    minFilterRow(MinFilter::LinearMipmapNearest, "GL_LINEAR_MIPMAP_NEAREST", N_("Linear, nearest mip"),
                 N_("2 × 2 texels of the best mip level. The change from level to level shows as a seam."),
                 N_("Nearest mip"), "Linear"),
    minFilterRow(MinFilter::NearestMipmapLinear, "GL_NEAREST_MIPMAP_LINEAR", N_("Nearest, blended mips"),
                 N_("One texel from each of two mip levels, blended. GL's initial value; without mipmaps the "
                    "texture is incomplete."),
                 N_("Blended mips"), "Nearest"),
    minFilterRow(MinFilter::LinearMipmapLinear, "GL_LINEAR_MIPMAP_LINEAR", N_("Trilinear"),
                 N_("2 × 2 texels from each of two mip levels, blended. No seams, the smoothest of the six."),
                 N_("Blended mips")),
};

constexpr EnumRow wrapRow(Wrap value, std::string_view name, std::string_view label, std::string_view help,
                          std::string_view since, std::string_view brief = {}) {
    return {static_cast<std::uint32_t>(value), name, label, help, since, {}, brief};
}

inline constexpr std::array wrapRows{
    wrapRow(Wrap::Repeat, "GL_REPEAT", N_("Repeat"),
            N_("Drops the integer part of the coordinate, so the image "
               "tiles."),
            "1.0"),
    wrapRow(Wrap::MirroredRepeat, "GL_MIRRORED_REPEAT", N_("Mirrored repeat"),
            N_("Tiles with every second copy reversed, so that edges meet without a seam."), "1.4",
            N_("Mirror")),
    wrapRow(Wrap::ClampToEdge, "GL_CLAMP_TO_EDGE", N_("Clamp to edge"),
            N_("The outermost texels of the image continue outside of it."), "1.2", N_("Edge")),
    wrapRow(Wrap::ClampToBorder, "GL_CLAMP_TO_BORDER", N_("Clamp to border"),
            N_("Outside the image is the border colour."), "1.3", N_("Border")),
    wrapRow(
        Wrap::Clamp, "GL_CLAMP", N_("Clamp (legacy)"),
        N_("Clamps the coordinate to [0, 1]. With a linear filter the edge is half image, half border colour."),
        "1.0", N_("Clamp")),
};

inline constexpr std::array targetRows{
    row(Target::Texture1D, "GL_TEXTURE_1D", "1D", "A line of texels, indexed by s alone.", "1.0"),
    row(Target::Texture2D, "GL_TEXTURE_2D", "2D", "An image, indexed by s and t.", "1.0"),
    row(Target::Texture3D, "GL_TEXTURE_3D", "3D",
        "A volume of slices, indexed by s, t and r. An image is a volume of one slice.", "1.2"),
    row(Target::CubeMap, "GL_TEXTURE_CUBE_MAP", "Cube map",
        "Six square faces around a centre. s, t and r are a direction, and the face that it hits is "
        "sampled. An image of 6:1, 1:6, 4:3 or 3:4 is cut into faces; any other is used for all six.",
        "1.3"),
};

inline constexpr std::array cubeFaceRows{
    row(CubeFace::PositiveX, "GL_TEXTURE_CUBE_MAP_POSITIVE_X", "+x", "The face to the right of the centre.",
        "1.3"),
    row(CubeFace::NegativeX, "GL_TEXTURE_CUBE_MAP_NEGATIVE_X", "-x", "The face to the left of the centre.",
        "1.3"),
    row(CubeFace::PositiveY, "GL_TEXTURE_CUBE_MAP_POSITIVE_Y", "+y", "The face above the centre.", "1.3"),
    row(CubeFace::NegativeY, "GL_TEXTURE_CUBE_MAP_NEGATIVE_Y", "-y", "The face below the centre.", "1.3"),
    row(CubeFace::PositiveZ, "GL_TEXTURE_CUBE_MAP_POSITIVE_Z", "+z",
        "The face in front of the centre, towards the viewer.", "1.3"),
    row(CubeFace::NegativeZ, "GL_TEXTURE_CUBE_MAP_NEGATIVE_Z", "-z", "The face behind the centre.", "1.3"),
};

template<>
struct EnumTable<MagFilter> {
    static constexpr std::span<const EnumRow> rows = magFilterRows;
};
template<>
struct EnumTable<MinFilter> {
    static constexpr std::span<const EnumRow> rows = minFilterRows;
};
template<>
struct EnumTable<Wrap> {
    static constexpr std::span<const EnumRow> rows = wrapRows;
};
template<>
struct EnumTable<Target> {
    static constexpr std::span<const EnumRow> rows = targetRows;
};
template<>
struct EnumTable<CubeFace> {
    static constexpr std::span<const EnumRow> rows = cubeFaceRows;
};

static_assert(magFilterRows.size() == 2 && minFilterRows.size() == 6);
static_assert(wrapRows.size() == 5 && targetRows.size() == 4 && cubeFaceRows.size() == 6);

} // namespace texplorer
