#pragma once

// What pixel transfer does to colours on their way into a texture: OpenGL 2.1, section 3.6.3, table 3.2. The
// initial factor is 1, the initial bias 0.

#include "core/gl/enum_row.h"

namespace texplorer {

/// Factors and biases of red, green, blue and alpha, in this order.
enum class PixelTransfer : std::uint32_t {
    RedScale = 0x0D14,
    GreenScale = 0x0D18,
    BlueScale = 0x0D1A,
    AlphaScale = 0x0D1C,
    RedBias = 0x0D15,
    GreenBias = 0x0D19,
    BlueBias = 0x0D1B,
    AlphaBias = 0x0D1D,
};

inline constexpr std::array pixelTransferRows{
    row(PixelTransfer::RedScale, "GL_RED_SCALE", "Red factor", "What red is multiplied by.", "1.0"),
    row(PixelTransfer::GreenScale, "GL_GREEN_SCALE", "Green factor", "What green is multiplied by.", "1.0"),
    row(PixelTransfer::BlueScale, "GL_BLUE_SCALE", "Blue factor", "What blue is multiplied by.", "1.0"),
    row(PixelTransfer::AlphaScale, "GL_ALPHA_SCALE", "Alpha factor", "What alpha is multiplied by.", "1.0"),
    row(PixelTransfer::RedBias, "GL_RED_BIAS", "Red bias", "What is added to red afterwards.", "1.0"),
    row(PixelTransfer::GreenBias, "GL_GREEN_BIAS", "Green bias", "What is added to green afterwards.", "1.0"),
    row(PixelTransfer::BlueBias, "GL_BLUE_BIAS", "Blue bias", "What is added to blue afterwards.", "1.0"),
    row(PixelTransfer::AlphaBias, "GL_ALPHA_BIAS", "Alpha bias", "What is added to alpha afterwards.", "1.0"),
};

template<>
struct EnumTable<PixelTransfer> {
    static constexpr std::span<const EnumRow> rows = pixelTransferRows;
};

static_assert(pixelTransferRows.size() == 8);

} // namespace texplorer
