#pragma once

#include <cstddef>

namespace texplorer {

/// What a decoder accepts at most; a file that claims more is refused before anything is allocated. The
/// defaults admit what OpenGL drivers do: 16384 x 16384 texels.
struct DecodeLimits {
    int maxExtent = 16384;                                     ///< along each axis
    std::size_t maxPixels = std::size_t{16384} * 16384;        ///< of one level of one face, all slices
    std::size_t maxBytes = std::size_t{16384} * 16384 * 4 * 2; ///< of everything that is decoded
    /// false: an outline, for which no pixel is decoded and no memory for pixels is taken. Its surfaces have
    /// their formats and extents, and no bytes. What only the pixels tell is missing: their damage, notes
    /// about them, and whether bits that may be alpha are (they count as what the header says).
    bool pixels = true;
    /// Every layer of an array, and what stands beside the picture (TextureImage::parts): for who writes it
    /// again. Without it an array's first layer is read.
    bool everything = false;
};

} // namespace texplorer
