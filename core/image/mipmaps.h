#pragma once

#include "core/gl/enum_row.h"
#include "core/image/image.h"
#include "core/image/mip_options.h"

namespace texplorer {

enum class MipPolicy : std::uint32_t { None, FromFile, Generated, Colored, Missing, Given };

inline constexpr std::array mipPolicyRows{
    row(MipPolicy::None, "none", "None",
        "Only the base level exists. A minifying filter that wants mipmaps then finds the texture "
        "incomplete."),
    row(MipPolicy::FromFile, "file", "From the file",
        "The levels that the file holds; where it holds fewer than a full chain, GL_TEXTURE_MAX_LEVEL stops "
        "at "
        "the last of them."),
    row(MipPolicy::Generated, "generated", "Generated",
        "Every level is made of the one before it: with a box filter as glGenerateMipmap does it."),
    row(MipPolicy::Colored, "colored", "Coloured",
        "Levels above the base are flat colours, so that one sees which level is sampled where."),
    row(MipPolicy::Missing, "missing", "One is missing",
        "The generated levels without one in the middle: incomplete for every filter with mipmaps, a common "
        "mistake."),
    row(MipPolicy::Given, "given", "One by one",
        "A picture of its own for each level, as many as there are: one that is missing, or has not half the "
        "size of the one before it, makes the texture incomplete."),
};

template<>
struct EnumTable<MipPolicy> {
    static constexpr std::span<const EnumRow> rows = mipPolicyRows;
};

static_assert(mipPolicyRows.size() == 6);

/// How many levels a complete chain has: floor(log2(largest extent)) + 1 (OpenGL 2.1, section 3.8.8).
[[nodiscard]] int mipLevelCount(int width, int height, int depth = 1);

/// The whole chain, base level first. Each level has max(1, floor(n / 2)) texels along every axis. The box
/// filter averages an axis of odd size with weights by coverage (three texels each), so that no texel is lost
/// and the average colour stays; it rounds to nearest. The other filters are those of stb_image_resize, with
/// clamped edges; volumes always take the box. Components are filtered apart from each other, alpha too.
/// An empty base gives an empty chain.
[[nodiscard]] MipChain buildMipChain(Image base, const MipOptions& options = {});

/// The chain that a policy makes of a base image: the base alone (None, and FromFile and Given, for a picture
/// is one level), the generated chain (Missing too: the upload leaves out `missingLevel`), or flat
/// mipColor(level) above the base.
[[nodiscard]] MipChain applyMipPolicy(MipPolicy policy, Image base, const MipOptions& options = {});

/// The same without the base, for a caller that has it and must not copy it. It is taken as it is, whatever
/// `options.npot` says.
[[nodiscard]] MipChain mipLevelsAbove(MipPolicy policy, const Image& base, const MipOptions& options = {});

/// The level that MipPolicy::Missing leaves out of a chain of `count`: one in the middle, never the base; -1
/// where there is only the base.
[[nodiscard]] constexpr int missingLevel(int count) {
    return count < 2 ? -1 : count / 2;
}

} // namespace texplorer
