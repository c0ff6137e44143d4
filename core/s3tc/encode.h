#pragma once

#include "core/base/result.h"
#include "core/image/block_image.h"
#include "core/image/image.h"
#include "core/s3tc/encode_quality.h"

#include <functional>
#include <stop_token>
#include <vector>

namespace texplorer {

/// To be raised with every change of the blocks that encodeBlocks makes: a cache of blocks compares it.
inline constexpr std::uint32_t encoderVersion = 3;

/// Called after rows of blocks with the share that is done, 0 to 1, on the thread that asked for the
/// encoding.
using Progress = std::function<void(float done)>;

/// Compresses a picture of any size and pixel format (edge blocks repeat the edge). DXT1 ignores alpha; DXT1
/// with 1-bit alpha makes alpha below 128 a hole; BC4 keeps red, BC5 red and green. Rows of blocks are
/// encoded on several threads, `threads` of them (0: as many as the processor has); the result is the same
/// with any number. Returns when it is done: a caller that must not wait calls it on a thread of its own.
///
/// Errors: OutOfRange for a picture without pixels, Malformed where `pixels` has not the size that the
/// extents ask for, Unsupported for signed formats and volumes, Cancelled after a stop request.
[[nodiscard]] Result<BlockImage> encodeBlocks(const Image& image, BlockFormat format, EncodeQuality quality,
                                              const Progress& progress = {}, std::stop_token stop = {},
                                              unsigned threads = 0);

/// The same for every level of a chain; `progress` is the share of all texels.
[[nodiscard]] Result<std::vector<BlockImage>> encodeLevels(const MipChain& chain, BlockFormat format,
                                                           EncodeQuality quality,
                                                           const Progress& progress = {},
                                                           const std::stop_token& stop = {});

} // namespace texplorer
