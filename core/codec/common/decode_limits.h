#pragma once

#include <cstddef>
#include <stop_token>

namespace texplorer {

/// The limits of a decoder; a file that states more is refused before memory is allocated. The defaults are
/// the limits of common OpenGL drivers: 16384 x 16384 texels.
struct DecodeLimits {
    int maxExtent = 16384;                                     ///< along each axis
    std::size_t maxPixels = std::size_t{16384} * 16384;        ///< of one level of one face, with all slices
    std::size_t maxBytes = std::size_t{16384} * 16384 * 4 * 2; ///< of all decoded data
    /// false: only an outline; no pixels are decoded and no memory for pixels is allocated. The surfaces have
    /// formats and extents, but no bytes. Information that needs the pixels is missing: damage in them, notes
    /// about them, and whether possible alpha bits are alpha (the header decides).
    bool pixels = true;
    /// Whether to read every layer of an array and the data that is not pixels (TextureImage::parts), for
    /// writing the file again. If false, only the first layer of an array is read.
    bool everything = false;
    /// If given, PNG and JPEG fail with Cancelled soon after its request. It must outlive the call.
    const std::stop_token* stop = nullptr;

    [[nodiscard]] bool isStopped() const { return stop != nullptr && stop->stop_requested(); }
};

} // namespace texplorer
