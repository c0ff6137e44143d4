#pragma once

#include "core/scene/params/params.h"

namespace texplorer::ui {

/// The range of dragged coordinates; `step` is a drag of one pixel in the list.
inline constexpr Range coordRange{-1000, 1000, 0.005F, {}};

// The actions of the buttons above the vertex list, on all coordinates of a model. r and q stay unchanged.

void scaleCoords(TexCoords& coords, float factor); ///< about (0, 0): 2 shows the image twice as often
void flipS(TexCoords& coords);                     ///< s becomes 1 - s
void flipT(TexCoords& coords);
void rotateQuarter(TexCoords& coords); ///< by 90 degrees counter-clockwise about (0.5, 0.5)

} // namespace texplorer::ui
