#pragma once

// Encoders of single blocks, for core/s3tc/encode.h.

#include "texplorer/s3tc/encode.h"

#include <cstddef>
#include <cstdint>

namespace texplorer {

/// Compresses 16 Rgba8 texels, row by row, to one block. May overwrite the texels. Thread-safe.
using BlockEncoder = void (*)(std::uint8_t* texels, std::byte* block);

/// Returns the encoder of a format and quality, or nullptr for signed formats.
///
///               Fast                     Normal                      Best
///   DXT1        stb_dxt                  stb_dxt, refined twice      cluster fit or Normal's
///   DXT1 alpha  stb_dxt; with holes:     stb_dxt, refined twice;     cluster fit or, without
///               libsquish range fit      with holes: cluster fit     holes, Normal's
///   DXT3        stb_dxt, alpha rounded   the same, refined twice     cluster fit or Normal's
///   DXT5        stb_dxt                  stb_dxt, refined twice      cluster fit or Normal's
///   BC4, BC5    stb_dxt                  libsquish or Fast's         as Normal
///
/// The cluster fit is libsquish's. Where two are named, each block (and each half of it) gets the result that
/// is closer to its texels: on gradients stb_dxt is up to 1 dB better, elsewhere the cluster fit is.
///
/// Measured on one core, as DXT1, with the pattern "planet" (512 x 256) and with 1/f noise (512 x 512):
///
///   stb_dxt                 62 and 41 Mpix/s     39.48 and 32.64 dB
///   stb_dxt, refined twice  58 and 23 Mpix/s     39.61 and 32.71 dB
///   libsquish cluster fit   0.8 and 0.4 Mpix/s   39.84 and 32.89 dB
///
/// Not used: libsquish's range fit (16 and 18 Mpix/s, 36.46 and 31.07 dB), worse and slower than stb_dxt, and
/// its iterative cluster fit (up to twice the time for 0.01 dB).
[[nodiscard]] BlockEncoder blockEncoder(BlockFormat format, EncodeQuality quality);

} // namespace texplorer
