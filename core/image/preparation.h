#pragma once

// Operations on a picture before it becomes a texture.

#include "texplorer/gl/enum_row.h"
#include "texplorer/image/image.h"

#include <glm/vec4.hpp>

namespace texplorer {

enum class ImageOp : std::uint32_t { Scale, Invert, Luminance, LuminanceToAlpha, AlphaFrom, Sharpen };

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
    row(ImageOp::Sharpen, "sharpen", "Sharpen",
        "Moves each colour away from the mean of its eight neighbours, by the amount."),
};

template<>
struct EnumTable<ImageOp> {
    static constexpr std::span<const EnumRow> rows = imageOpRows;
};

static_assert(imageOpRows.size() == 6);

/// An operation and its parameters. Colours are red, green, blue and alpha.
struct Operation {
    ImageOp op = ImageOp::Scale;
    glm::vec4 factor{1}; ///< for Scale
    glm::vec4 bias{0};   ///< for Scale
    float amount = 1;    ///< for Sharpen
    /// For AlphaFrom: its luminance becomes alpha; of an alpha image, its alpha.
    const Image* other = nullptr;
};

/// Applies an operation; the result has the smallest format that can hold it.
/// - Scale works like GL's pixel transfer (OpenGL 2.1, section 3.6.5): on all four components, where missing
///   colours are 0 and a missing alpha is 1; the result is clamped to [0, 1] and rounded to the nearest of
///   256 values.
/// - Luminance is (299 red + 587 green + 114 blue) / 1000, rounded.
/// - AlphaFrom averages the other image over the area of each texel (scaleByCoverage); without another image
///   it changes nothing.
/// - Sharpen works on each slice, and beyond an edge the nearest texel repeats: c + amount * (c - mean of the
///   eight neighbours), rounded and clamped. Alpha stays.
/// An image of alpha alone has no colours: Invert, Luminance, LuminanceToAlpha and Sharpen return it
/// unchanged. Images of depths and empty images are returned unchanged.
[[nodiscard]] Image prepared(Image image, const Operation& operation);

} // namespace texplorer
