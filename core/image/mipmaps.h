#pragma once

#include "texplorer/gl/enum_row.h"
#include "texplorer/image/image.h"
#include "texplorer/image/mip_options.h"

namespace texplorer {

enum class MipPolicy : std::uint32_t {
    None,
    FromFile,
    Generated,
    Colored,
    Missing,
    Given,
    GenerateMipmap,
    OnUpload,
    Glu
};

inline constexpr std::array mipPolicyRows{
    row(MipPolicy::None, "none", "None",
        "Only the base level exists. The texture is then incomplete for filters that use mipmaps."),
    row(MipPolicy::FromFile, "file", "From the file",
        "The levels of the file. If these are fewer than a full chain, GL_TEXTURE_MAX_LEVEL is set to the "
        "last of them."),
    row(MipPolicy::Generated, "generated", "Generated",
        "Every level is made from the one before it; with a box filter as in glGenerateMipmap."),
    row(MipPolicy::Colored, "colored", "Coloured",
        "Levels above the base are flat colours, which show where each level is sampled."),
    row(MipPolicy::Missing, "missing", "One is missing",
        "The generated levels without one in the middle. Incomplete for every filter with mipmaps, a "
        "common mistake."),
    row(MipPolicy::Given, "given", "One by one",
        "A separate image for each level. The texture is incomplete if one is missing or does not have "
        "half the size of the one before it."),
    row(MipPolicy::GenerateMipmap, "glGenerateMipmap", "By the driver",
        "The driver makes the levels after the upload of the base, usually with a box filter. A function of "
        "OpenGL 3.0 and GL_ARB_framebuffer_object.",
        "3.0"),
    row(MipPolicy::OnUpload, "GL_GENERATE_MIPMAP", "On upload",
        "A parameter of the texture: the driver makes the levels with every upload of the base. OpenGL 3.1 "
        "removed it.",
        "1.4"),
    row(MipPolicy::Glu, "gluBuild2DMipmaps", "By GLU",
        "GLU scales the image to powers of two, makes the levels with a box filter and uploads all of them; of "
        "other targets with gluBuild1DMipmaps or gluBuild3DMipmaps.",
        "1.0"),
};

template<>
struct EnumTable<MipPolicy> {
    static constexpr std::span<const EnumRow> rows = mipPolicyRows;
};

static_assert(mipPolicyRows.size() == 9);

/// Whether OpenGL makes the levels above the base.
[[nodiscard]] constexpr bool isMadeByDriver(MipPolicy policy) {
    return policy == MipPolicy::GenerateMipmap || policy == MipPolicy::OnUpload;
}

/// Whether MipOptions choose how levels are averaged; drivers and GLU have a filter of their own.
[[nodiscard]] constexpr bool takesFilter(MipPolicy policy) {
    return policy == MipPolicy::Generated || policy == MipPolicy::Missing;
}

/// The number of levels of a complete chain: floor(log2(largest extent)) + 1 (OpenGL 2.1, section 3.8.8).
[[nodiscard]] int mipLevelCount(int width, int height, int depth = 1);

/// Builds the whole chain, base level first. Each level has max(1, floor(n / 2)) texels along every axis. The
/// box filter averages an axis of odd size with weights by coverage (three texels each), so every texel
/// counts and the mean colour stays; it rounds to nearest. The other filters are those of stb_image_resize,
/// with clamped edges; volumes always use the box. Components are filtered separately, alpha too; then each
/// level's alpha is scaled to the base's coverage, if the options ask for it. An empty base gives an empty
/// chain.
[[nodiscard]] MipChain buildMipChain(Image base, const MipOptions& options = {});

/// Returns the chain of a policy: the base alone (None; FromFile and Given, as a picture has one level), the
/// generated chain (Missing too: the upload leaves out `missingLevel`; those that a driver or GLU makes have
/// the box filter), or plain mipColor(level) above the base.
[[nodiscard]] MipChain applyMipPolicy(MipPolicy policy, Image base, const MipOptions& options = {});

/// The same without the base, to avoid a copy. The base is used as it is; `options.npot` is ignored.
[[nodiscard]] MipChain mipLevelsAbove(MipPolicy policy, const Image& base, const MipOptions& options = {});

/// The level that MipPolicy::Missing leaves out of a chain of `count` levels: one in the middle, never the
/// base; -1 if there is only the base.
[[nodiscard]] constexpr int missingLevel(int count) {
    return count < 2 ? -1 : count / 2;
}

} // namespace texplorer
