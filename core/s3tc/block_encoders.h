#pragma once

// One block at a time, behind core/s3tc/encode.h.

#include "core/s3tc/encode.h"

#include <cstddef>
#include <cstdint>

namespace texplorer {

/// Compresses 16 Rgba8 texels, row by row, into one block. May overwrite the texels. Thread-safe.
using BlockEncoder = void (*)(std::uint8_t* texels, std::byte* block);

/// The encoder of a format and quality, or nullptr for signed formats.
///
///               Fast                          Normal                  Best
///   DXT1        stb_dxt                       libsquish range fit     libsquish cluster fit
///   DXT1 alpha  stb_dxt; blocks with holes:   libsquish range fit     libsquish cluster fit
///               libsquish range fit
///   DXT3        stb_dxt, alpha rounded        libsquish range fit     libsquish cluster fit
///   DXT5        stb_dxt                       libsquish range fit     libsquish cluster fit
///   BC4, BC5    stb_dxt                       libsquish               libsquish
///
/// Measured on a photo of 2 megatexels: stb_dxt 82 Mpix/s and 37.6 dB, range fit 51 Mpix/s, cluster fit
/// 1.4 Mpix/s and 2.2 dB above range fit; iterative cluster fit takes 1.4 times as long for the same dB.
[[nodiscard]] BlockEncoder blockEncoder(BlockFormat format, EncodeQuality quality);

} // namespace texplorer
