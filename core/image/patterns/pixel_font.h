#pragma once

#include "texplorer/image/patterns/canvas.h"

#include <string_view>

namespace texplorer {

inline constexpr int glyphHeight = 7;

/// The width of a text in font pixels; characters that the font lacks count as spaces.
[[nodiscard]] int textWidth(std::string_view text);

/// Draws a text with its lower left corner at (x, y), each font pixel as a square of `scale` texels.
void drawText(Canvas& canvas, int x, int y, int scale, std::string_view text, Color color);

} // namespace texplorer
