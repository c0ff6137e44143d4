#pragma once

// Operations on a picture before it becomes a texture.

#include "texplorer/gl/enum_row.h"
#include "texplorer/image/image.h"

#include <glm/vec4.hpp>

#include <array>

namespace texplorer {

enum class ImageOp : std::uint32_t {
    Scale,
    Invert,
    Luminance,
    LuminanceToAlpha,
    AlphaFrom,
    Swizzle,
    Premultiply,
    Spread,
    Sharpen,
    Resize,
    Normals
};

/// Where a component of a swizzled image comes from.
enum class ComponentSource : std::uint32_t {
    Red,
    Green,
    Blue,
    Alpha,
    Luminance,
    OtherRed,
    OtherGreen,
    OtherBlue,
    OtherAlpha,
    OtherLuminance,
    Zero,
    One
};

[[nodiscard]] constexpr bool isOfOther(ComponentSource source) {
    return source >= ComponentSource::OtherRed && source <= ComponentSource::OtherLuminance;
}

inline constexpr std::array imageOpRows{
    row(ImageOp::Scale, "scale", "Scale and bias",
        "Each component times a factor plus a bias, clamped, as glPixelTransferf does during upload "
        "(GL_RED_SCALE, GL_RED_BIAS)."),
    row(ImageOp::Invert, "invert", "Invert", "Each colour becomes one minus itself. Alpha is unchanged."),
    row(ImageOp::Luminance, "luminance", "Colour to luminance",
        "Red, green and blue become their luminance: 0.299 red, 0.587 green, 0.114 blue. Used for height "
        "maps."),
    row(ImageOp::LuminanceToAlpha, "luminance-to-alpha", "Luminance to alpha",
        "Alpha becomes the luminance of the colours, which are unchanged. Used to store heights with an "
        "image."),
    row(ImageOp::AlphaFrom, "alpha-from", "Alpha from another image",
        "Alpha becomes the luminance of another image, scaled to this one's size: colour from one file, "
        "shape from another."),
    row(ImageOp::Swizzle, "swizzle", "Swizzle",
        "Each component becomes any other one, of this image or of another: to exchange red and blue, or to "
        "pack two images into one."),
    row(ImageOp::Premultiply, "premultiply", "Premultiply",
        "Each colour times alpha, for blending with GL_ONE and GL_ONE_MINUS_SRC_ALPHA. Filters then mix "
        "nothing invisible into edges."),
    row(ImageOp::Spread, "spread", "Spread colours",
        "Texels with an alpha of 0 take the colours of the nearest visible ones, so that filters mix no "
        "others into edges. Alpha is unchanged."),
    row(ImageOp::Sharpen, "sharpen", "Sharpen",
        "Moves each colour away from the mean of its eight neighbours, by the amount."),
    row(ImageOp::Resize, "resize", "Resize",
        "Scales to a share of its size, or to a number of texels, as with gluScaleImage, for a driver whose "
        "textures are smaller."),
    row(ImageOp::Normals, "normals", "Normals",
        "Luminance is a height, and red, green and blue become the normal of the surface, for a bump map "
        "with GL_DOT3_RGB."),
};

inline constexpr std::array componentSourceRows{
    row(ComponentSource::Red, "red", "Red", "This image's red."),
    row(ComponentSource::Green, "green", "Green", "This image's green."),
    row(ComponentSource::Blue, "blue", "Blue", "This image's blue."),
    row(ComponentSource::Alpha, "alpha", "Alpha", "This image's alpha."),
    row(ComponentSource::Luminance, "luminance", "Luminance", "0.299 red, 0.587 green, 0.114 blue."),
    row(ComponentSource::OtherRed, "other-red", "Other's red", "The other image's red, at this one's size."),
    row(ComponentSource::OtherGreen, "other-green", "Other's green",
        "The other image's green, at this one's size."),
    row(ComponentSource::OtherBlue, "other-blue", "Other's blue",
        "The other image's blue, at this one's size."),
    row(ComponentSource::OtherAlpha, "other-alpha", "Other's alpha",
        "The other image's alpha, at this one's size."),
    row(ComponentSource::OtherLuminance, "other-luminance", "Other's grey",
        "The other image's luminance, at this one's size."),
    row(ComponentSource::Zero, "zero", "Zero", "0 for every texel."),
    row(ComponentSource::One, "one", "One", "1 for every texel."),
};

template<>
struct EnumTable<ImageOp> {
    static constexpr std::span<const EnumRow> rows = imageOpRows;
};

template<>
struct EnumTable<ComponentSource> {
    static constexpr std::span<const EnumRow> rows = componentSourceRows;
};

static_assert(imageOpRows.size() == 11 && componentSourceRows.size() == 12);

/// An operation and its parameters. Colours are red, green, blue and alpha.
struct Operation {
    ImageOp op = ImageOp::Scale;
    glm::vec4 factor{1}; ///< for Scale
    glm::vec4 bias{0};   ///< for Scale
    float amount = 1;    ///< for Sharpen and Normals
    /// For Swizzle: where red, green, blue and alpha come from.
    std::array<ComponentSource, 4> components{ComponentSource::Red, ComponentSource::Green,
                                              ComponentSource::Blue, ComponentSource::Alpha};
    std::array<int, 3> extent{}; ///< for Resize: at least 1
    bool topFirst = false;       ///< for Normals: row 0 is the top one
    /// For AlphaFrom and Swizzle. The luminance of an alpha image is its alpha.
    const Image* other = nullptr;
};

/// Applies an operation; the result has the smallest format that can hold it.
/// - Scale works like GL's pixel transfer (OpenGL 2.1, section 3.6.5): on all four components, where missing
///   colours are 0 and a missing alpha is 1; the result is clamped to [0, 1] and rounded to the nearest of
///   256 values.
/// - Luminance is (299 red + 587 green + 114 blue) / 1000, rounded.
/// - AlphaFrom and Swizzle average components of the other image over the area of each texel
///   (scaleByCoverage); if they need it and there is none, they change nothing.
/// - Premultiply is colour * alpha / 255, rounded.
/// - Spread works on each slice and within its edges, in rings around the texels whose alpha is above 0: the
///   colours of each texel of a ring are the rounded mean of those of its eight neighbours that lie in the
///   rings before. If no alpha is above 0, nothing changes.
/// - Sharpen works on each slice, and beyond an edge the nearest texel repeats: c + amount * (c - mean of the
///   eight neighbours), rounded and clamped. Alpha stays.
/// - Resize averages over the area of each texel (scaleByCoverage).
/// - Normals works on each slice, and beyond an edge the image repeats, as with GL_REPEAT. White is `amount`
///   texels high. The slopes are half the differences between the right and the left neighbour, and between
///   the upper and the lower one; the normal is (-slope, -slope, 1), normalised, stored as n / 2 + 1/2.
/// An image of alpha alone has no colours: of it Invert, Luminance, LuminanceToAlpha, Premultiply, Spread,
/// Sharpen and Normals change nothing. Images of depths and empty images are returned unchanged.
[[nodiscard]] Image prepared(Image image, const Operation& operation);

} // namespace texplorer
