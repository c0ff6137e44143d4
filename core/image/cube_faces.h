#pragma once

// Converts a picture to the six faces of a cube map. The faces are +x, -x, +y, -y, +z, -z in this order, and
// their row 0 is the top one: unlike for every other texture, the first row of a face in OpenGL is its top
// (OpenGL 2.1, table 3.19: t grows downwards on the sides). All functions take pictures whose row 0 is the
// top row.

#include "texplorer/image/image.h"

namespace texplorer {

inline constexpr int cubeFaceCount = 6;

/// The layouts of six faces in one picture.
enum class CubeLayout : std::uint8_t {
    Same,        ///< no layout: the whole picture is each face
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

/// Determined by the ratio of the sides alone.
[[nodiscard]] CubeLayout cubeLayout(int width, int height);

/// The extents of a face, for a picture of these extents.
struct FaceExtents {
    int width = 0;
    int height = 0;
};
[[nodiscard]] FaceExtents cubeFaceExtents(int width, int height);

/// Returns one face of a picture; of a volume, of its first slice.
[[nodiscard]] Image cubeFace(const Image& picture, int face);

/// Returns six square faces of one size and format as a RowCross; uncovered parts are 0.
[[nodiscard]] Image cubeCross(std::span<const Image, cubeFaceCount> faces);

} // namespace texplorer
