#pragma once

#include "texplorer/base/result.h"
#include "texplorer/image/block_image.h"
#include "texplorer/image/image.h"
#include "texplorer/s3tc/encode_quality.h"

#include <functional>
#include <stop_token>
#include <vector>

namespace texplorer {

/// Must be increased with every change of the blocks that encodeBlocks makes: caches of blocks compare it.
inline constexpr std::uint32_t encoderVersion = 3;

/// Whether encodeBlocks makes blocks of a format.
[[nodiscard]] bool isEncoded(BlockFormat format);

/// Called after rows of blocks with the finished share, 0 to 1, on the thread that called the encoder.
using Progress = std::function<void(float done)>;

/// Compresses a picture of any size and pixel format (edge blocks repeat the edge). DXT1 ignores alpha; DXT1
/// with 1-bit alpha makes texels with alpha below 128 transparent; BC4 keeps red, BC5 red and green. Rows of
/// blocks are encoded on `threads` threads (0: one per processor); the result does not depend on their
/// number. Blocks until it is done.
///
/// Errors: OutOfRange for a picture without pixels, Malformed if the size of `pixels` does not match the
/// extents, Unsupported for signed formats and volumes, Cancelled after a stop request.
[[nodiscard]] Result<BlockImage> encodeBlocks(const Image& image, BlockFormat format, EncodeQuality quality,
                                              const Progress& progress = {}, std::stop_token stop = {},
                                              unsigned threads = 0);

/// The same for every level of a chain; `progress` is the share of all texels.
[[nodiscard]] Result<std::vector<BlockImage>> encodeLevels(const MipChain& chain, BlockFormat format,
                                                           EncodeQuality quality,
                                                           const Progress& progress = {},
                                                           const std::stop_token& stop = {});

} // namespace texplorer
