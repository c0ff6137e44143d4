#pragma once

// What is done to a picture before it becomes a texture.

#include "core/gl/enum_row.h"
#include "core/image/image.h"

#include <glm/vec4.hpp>

namespace texplorer {

enum class ImageOp : std::uint32_t { Scale, Invert, Luminance, LuminanceToAlpha, AlphaFrom, Sharpen };

inline constexpr std::array imageOpRows{
    row(ImageOp::Scale, "scale", "Scale and bias",
        "Each component times a factor, plus a bias, and clamped: what glPixelTransferf does while a picture is "
        "uploaded (GL_RED_SCALE, GL_RED_BIAS)."),
    row(ImageOp::Invert, "invert", "Invert", "Each colour becomes one minus itself; alpha stays."),
    row(ImageOp::Luminance, "luminance", "Colour to luminance",
        "Red, green and blue become their luminance: 0.299 red, 0.587 green, 0.114 blue. A height map is made "
        "like that."),
    row(ImageOp::LuminanceToAlpha, "luminance-to-alpha", "Luminance to alpha",
        "Alpha becomes the luminance of the colours, which stay: heights that travel with a picture."),
    row(ImageOp::AlphaFrom, "alpha-from", "Alpha from another picture",
        "Alpha becomes the luminance of another picture, scaled to this one's size: colour from one file, shape "
        "from another."),
    row(ImageOp::Sharpen, "sharpen", "Sharpen",
        "Each colour moves away from the mean of its eight neighbours, by the amount."),
};

template<>
struct EnumTable<ImageOp> {
    static constexpr std::span<const EnumRow> rows = imageOpRows;
};

static_assert(imageOpRows.size() == 6);

/// One operation with what it asks for. Colours are red, green, blue and alpha.
struct Operation {
    ImageOp op = ImageOp::Scale;
    glm::vec4 factor{1};          ///< for Scale
    glm::vec4 bias{0};            ///< for Scale
    float amount = 1;             ///< for Sharpen
    const Image* other = nullptr; ///< for AlphaFrom: whose luminance becomes alpha; of ALPHA, its alpha
};

/// The image after an operation, in the least format that holds it.
/// - Scale works as GL's pixel transfer does (OpenGL 2.1, section 3.6.5): on the components that the format
///   stands for, where missing colours are 0 and a missing alpha is 1; then it clamps to [0, 1] and rounds
///   to the nearest of 256 values.
/// - Luminance is (299 red + 587 green + 114 blue) / 1000, rounded.
/// - AlphaFrom averages the other image over what each texel covers (scaleByCoverage); without one it changes
///   nothing.
/// - Sharpen takes each slice for itself, and a neighbour beyond an edge is the nearest texel of it:
///   c + amount * (c - mean of the eight), rounded and clamped. Alpha stays.
/// An image of alpha alone has no colours: Invert, Luminance, LuminanceToAlpha and Sharpen return it as it
/// is. An image of depths stays as it is, and an empty one empty.
[[nodiscard]] Image prepared(Image image, const Operation& operation);

} // namespace texplorer
