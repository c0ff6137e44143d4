#pragma once

// How the levels of a mip chain are made of the image.

#include "core/gl/enum_row.h"

namespace texplorer {

enum class MipFilter : std::uint32_t { Box, Triangle, Cubic, CatmullRom, Mitchell };
enum class NpotPolicy : std::uint32_t { Keep, PowerOfTwo };

struct MipOptions {
    MipFilter filter = MipFilter::Box;
    bool linearLight = false; ///< colours are averaged as light (sRGB's curve); alpha as it is
    NpotPolicy npot = NpotPolicy::Keep;

    bool operator==(const MipOptions&) const = default;
};

// A Kaiser window, which texture tools like, is not among them: stb_image_resize has none.
inline constexpr std::array mipFilterRows{
    row(MipFilter::Box, "box", "Box",
        "The average of the texels that lie below: what glGenerateMipmap and gluBuild2DMipmaps do."),
    row(MipFilter::Triangle, "triangle", "Triangle",
        "Near texels count more than far ones, over twice the width: smoother than a box."),
    row(MipFilter::Cubic, "cubic", "Cubic B-spline",
        "A smooth bell: no ringing at all, and the softest levels of all."),
    row(MipFilter::CatmullRom, "catmull-rom", "Catmull-Rom",
        "Sharp: it overshoots at edges, so that small levels stay crisp."),
    row(MipFilter::Mitchell, "mitchell", "Mitchell-Netravali",
        "Between the B-spline and Catmull-Rom: little blur, little ringing."),
};

inline constexpr std::array npotPolicyRows{
    row(NpotPolicy::Keep, "keep", "Keep",
        "Any size, as OpenGL 2.0 and later take it; an odd level is halved with rounding down."),
    row(NpotPolicy::PowerOfTwo, "power-of-two", "Nearest power of two",
        "The image is scaled first, as gluBuild2DMipmaps does it: 640 becomes 512, 800 becomes 1024."),
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
