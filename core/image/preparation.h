#pragma once

// What is done to a picture before it becomes a texture.

#include "core/gl/enum_row.h"

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

} // namespace texplorer
