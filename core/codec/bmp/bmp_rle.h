#pragma once

// RLE4 and RLE8 of BMP files. Private to the BMP codec.
//
//   n v        n > 0: n pixels of index v; in RLE4 v is two indices that take turns, the high one first
//   0 0        end of the row
//   0 1        end of the picture
//   0 2 x y    go x to the right and y rows on
//   0 n …      n >= 3: n indices as they are, padded to a multiple of two bytes

#include "core/base/bytes.h"

#include <cstdint>
#include <span>

namespace texplorer::bmp {

/// What a file's codes were, counted: for the decoder's notes and for the anatomy.
struct RleReport {
    std::size_t consumed = 0; ///< bytes of codes
    std::size_t runs = 0;
    std::size_t literals = 0;
    std::size_t deltas = 0;
    std::size_t clipped = 0; ///< codes that went on beyond a row's end or began behind the last row
    std::size_t painted = 0; ///< pixels
    int row = 0;             ///< where the codes ended, from the first row of the file
    int column = 0;
    bool ended = false; ///< by the end-of-picture code, not because the bytes ran out
};

/// Receives whole rows in the file's order. Rows that nothing was painted on may be left out.
class RleRows {
public:
    RleRows() = default;
    RleRows(const RleRows&) = delete;
    RleRows& operator=(const RleRows&) = delete;
    virtual ~RleRows() = default;
    virtual void row(int y, ByteView indices) = 0;
};

/// Follows the codes with one row of memory. Pixels that are skipped have index 0.
RleReport decodeRle(ByteView codes, int bitsPerPixel, int width, int height, RleRows& rows);

} // namespace texplorer::bmp
