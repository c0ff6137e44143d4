#pragma once

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/s3tc/block_image.h"

#include <functional>
#include <stop_token>

namespace texplorer {

enum class EncodeQuality : std::uint32_t { Fast, Normal, Best };

inline constexpr std::array encodeQualityRows{
    row(EncodeQuality::Fast, "fast", "Fast", "For trying things out: tens of megatexels a second."),
    row(EncodeQuality::Normal, "normal", "Normal", "Range fit: a good picture in a short time."),
    row(EncodeQuality::Best, "best", "Best",
        "Cluster fit: the best picture, about half a megatexel a second."),
};

template<>
struct EnumTable<EncodeQuality> {
    static constexpr std::span<const EnumRow> rows = encodeQualityRows;
};

static_assert(encodeQualityRows.size() == 3);

/// Called now and then with the share that is done, 0 to 1, on the encoding thread.
using Progress = std::function<void(float done)>;

/// Compresses a picture of any size and pixel format (edge blocks repeat the edge). Signed formats and
/// volumes are not encoded. A stop request ends it with ErrorCode::Cancelled.
[[nodiscard]] Result<BlockImage> encodeBlocks(const Image& image, BlockFormat format, EncodeQuality quality,
                                              const Progress& progress = {}, std::stop_token stop = {});

} // namespace texplorer
