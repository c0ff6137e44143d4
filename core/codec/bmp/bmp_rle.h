#pragma once

// RLE4 and RLE8 of BMP files. Private to the BMP codec.
//
//   n v        n > 0: n pixels of index v; in RLE4, v is two alternating indices, the high one first
//   0 0        end of the row
//   0 1        end of the picture
//   0 2 x y    go x pixels to the right and y rows on
//   0 n …      n >= 3: n literal indices, padded to a multiple of two bytes

#include "texplorer/base/bytes.h"

#include <cstdint>
#include <span>

namespace texplorer::bmp {

/// Statistics of a file's codes, for the decoder's notes and the anatomy.
struct RleReport {
    std::size_t consumed = 0; ///< bytes of codes
    std::size_t runs = 0;
    std::size_t literals = 0;
    std::size_t deltas = 0;
    std::size_t clipped = 0; ///< codes that ran over the end of a row or began after the last row
    std::size_t painted = 0; ///< pixels
    int row = 0;             ///< where the codes ended, counted from the file's first row
    int column = 0;
    bool ended = false; ///< by the end-of-picture code, not by the end of the data
};

/// Receives whole rows in the file's order. Rows without pixels may be left out.
class RleRows {
public:
    RleRows() = default;
    RleRows(const RleRows&) = delete;
    RleRows& operator=(const RleRows&) = delete;
    virtual ~RleRows() = default;
    virtual void row(int y, ByteView indices) = 0;
};

/// Decodes with the memory of one row. Skipped pixels have index 0.
RleReport decodeRle(ByteView codes, int bitsPerPixel, int width, int height, RleRows& rows);

} // namespace texplorer::bmp
