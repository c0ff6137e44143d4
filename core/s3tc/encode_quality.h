#pragma once

#include "core/gl/enum_row.h"

namespace texplorer {

/// How much time is spent on a block.
enum class EncodeQuality : std::uint32_t { Fast, Normal, Best };

inline constexpr std::array encodeQualityRows{
    row(EncodeQuality::Fast, "fast", "Fast", "For trying things out: tens of megatexels a second."),
    row(EncodeQuality::Normal, "normal", "Balanced",
        "Each block's end colours are refined twice: somewhat better, and nearly as quick."),
    row(EncodeQuality::Best, "best", "Best",
        "Cluster fit: the best picture, about half a megatexel a second."),
};

template<>
struct EnumTable<EncodeQuality> {
    static constexpr std::span<const EnumRow> rows = encodeQualityRows;
};

static_assert(encodeQualityRows.size() == 3);

} // namespace texplorer
