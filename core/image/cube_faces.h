#pragma once

// A picture as the six faces of a cube map. Faces are +x, -x, +y, -y, +z, -z in this order, and their row 0
// is the top one: unlike those of every other texture, the first row that OpenGL gets of a face is its top
// (OpenGL 2.1, table 3.19: t grows downwards on the sides). All functions take pictures whose row 0 is the
// top row.

#include "core/image/image.h"

namespace texplorer {

inline constexpr int cubeFaceCount = 6;

/// How six faces lie in one picture.
enum class CubeLayout : std::uint8_t {
    Same,        ///< none of the others: the whole picture is each face
    RowStrip,    ///< 6:1, from left to right
    ColumnStrip, ///< 1:6, from top to bottom
    RowCross,    ///< 4:3
    ColumnCross, ///< 3:4
};

//      RowCross           ColumnCross
//
//         +y                  +y
//     -x  +z  +x  -z      -x  +z  +x
//         -y                  -y
//                             -z, turned by 180 degrees

/// By the sides' ratio alone.
[[nodiscard]] CubeLayout cubeLayout(int width, int height);

/// One side of a face, for a picture of these extents.
struct FaceExtents {
    int width = 0;
    int height = 0;
};
[[nodiscard]] FaceExtents cubeFaceExtents(int width, int height);

/// One face, cut out of a picture; of a volume, of its first slice.
[[nodiscard]] Image cubeFace(const Image& picture, int face);

/// Six square faces of one size and format as a RowCross; what no face covers is 0.
[[nodiscard]] Image cubeCross(std::span<const Image, cubeFaceCount> faces);

} // namespace texplorer
