#pragma once

#include "texplorer/gl/enum_row.h"

namespace texplorer {

/// The effort per block.
enum class EncodeQuality : std::uint32_t { Fast, Normal, Best };

inline constexpr std::array encodeQualityRows{
    row(EncodeQuality::Fast, "fast", "Fast", "For quick trials: tens of megatexels a second."),
    row(EncodeQuality::Normal, "normal", "Balanced",
        "Refines the end colours of each block twice: slightly better and nearly as fast."),
    row(EncodeQuality::Best, "best", "Best",
        "Cluster fit: the best quality, about half a megatexel a second."),
};

template<>
struct EnumTable<EncodeQuality> {
    static constexpr std::span<const EnumRow> rows = encodeQualityRows;
};

static_assert(encodeQualityRows.size() == 3);

} // namespace texplorer
