#pragma once

// How the levels of a mip chain are computed.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class MipFilter : std::uint32_t { Box, Triangle, Cubic, CatmullRom, Mitchell };
enum class NpotPolicy : std::uint32_t { Keep, PowerOfTwo };

struct MipOptions {
    MipFilter filter = MipFilter::Box;
    bool linearLight = false; ///< averages colours as linear light (sRGB's curve); alpha is not converted
    NpotPolicy npot = NpotPolicy::Keep;
    /// Above 0: an alpha test's reference, whose coverage the levels keep (alpha_coverage.h).
    float coverage = 0;

    bool operator==(const MipOptions&) const = default;
};

// A Kaiser window, common in texture tools, is missing: stb_image_resize has none.
inline constexpr std::array mipFilterRows{
    row(MipFilter::Box, "box", "Box",
        "The average of the texels that it covers in the level before, as in glGenerateMipmap and gluBuild2DMipmaps."),
    row(MipFilter::Triangle, "triangle", "Triangle",
        "Near texels weigh more than far ones, over twice the width. Smoother than a box."),
    row(MipFilter::Cubic, "cubic", "Cubic B-spline",
        "A smooth bell curve. No ringing, and the softest levels."),
    row(MipFilter::CatmullRom, "catmull-rom", "Catmull-Rom",
        "Sharp. It overshoots at edges, so small levels stay crisp."),
    row(MipFilter::Mitchell, "mitchell", "Mitchell-Netravali",
        "Between the B-spline and Catmull-Rom: little blur, little ringing."),
};

inline constexpr std::array npotPolicyRows{
    // Translators: a size that is no power of two is kept
    row(NpotPolicy::Keep, "keep", "Keep",
        "Any size, as in OpenGL 2.0 and later. Odd sizes are halved and rounded down."),
    row(NpotPolicy::PowerOfTwo, "power-of-two", "Nearest power of two",
        "The image is scaled first, as in gluBuild2DMipmaps: 640 becomes 512, 800 becomes 1024."),
};

template<>
struct EnumTable<MipFilter> {
    static constexpr std::span<const EnumRow> rows = mipFilterRows;
};
template<>
struct EnumTable<NpotPolicy> {
    static constexpr std::span<const EnumRow> rows = npotPolicyRows;
};

static_assert(mipFilterRows.size() == 5 && npotPolicyRows.size() == 2);

} // namespace texplorer
