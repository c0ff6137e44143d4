#pragma once

#include "core/gl/enum_row.h"
#include "core/image/image.h"

namespace texplorer {

enum class MipPolicy : std::uint32_t { None, Generated, Colored };

inline constexpr std::array mipPolicyRows{
    row(MipPolicy::None, "none", "None",
        "Only the base level exists. A minifying filter that wants mipmaps then finds the texture "
        "incomplete."),
    row(MipPolicy::Generated, "generated", "Generated",
        "Every level is the 2 x 2 box average of the one before it, as glGenerateMipmap does it."),
    row(MipPolicy::Colored, "colored", "Coloured",
        "Levels above the base are flat colours, so that one sees which level is sampled where."),
};

template<>
struct EnumTable<MipPolicy> {
    static constexpr std::span<const EnumRow> rows = mipPolicyRows;
};

static_assert(mipPolicyRows.size() == 3);

/// How many levels a complete chain has: floor(log2(largest extent)) + 1 (OpenGL 2.1, section 3.8.8).
[[nodiscard]] int mipLevelCount(int width, int height, int depth = 1);

/// The whole chain of a box filter, base level first. Each level has max(1, floor(n / 2)) texels along every
/// axis; an axis of odd size is averaged with weights by coverage (three texels each), so that no texel is
/// lost and the average colour stays. Rounds to nearest. An empty base gives an empty chain.
[[nodiscard]] MipChain buildMipChain(Image base);

/// The chain that a policy makes of a base image: the base alone, the box chain, or flat mipColor(level)
/// above it.
[[nodiscard]] MipChain applyMipPolicy(MipPolicy policy, Image base);

} // namespace texplorer
