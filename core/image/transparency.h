#pragma once

// Ways to make the alpha of a texture: the choices of glpng, the PNG loader of many OpenGL courses (pngBind's
// `trans`, pngSetStencil), for any image.

#include "texplorer/gl/enum_row.h"
#include "texplorer/image/image.h"

namespace texplorer {

enum class Transparency : std::uint32_t {
    File,
    Solid,
    Alpha,
    Stencil,
    Blend1,
    Blend2,
    Blend3,
    Blend4,
    Blend5,
    Blend6,
    Blend7,
    Blend8,
};

inline constexpr std::array transparencyRows{
    row(Transparency::File, "file", "As in the file", "Alpha as stored in the file (glpng: PNG_ALPHA)."),
    row(Transparency::Solid, "solid", "Solid",
        "No transparency. The alpha of the file is ignored (glpng: PNG_SOLID)."),
    row(Transparency::Alpha, "alpha", "Alpha, always",
        "The alpha of the file, or opaque where the file has none."),
    row(Transparency::Stencil, "stencil", "Stencil by colour",
        "Texels of exactly the chosen colour are invisible, all others opaque (glpng: PNG_STENCIL)."),
    row(Transparency::Blend1, "blend1", "a = r + g + b",
        "Dark colours are transparent: the sum of the components, at most 255 (glpng: PNG_BLEND1)."),
    row(Transparency::Blend2, "blend2", "a = (r + g + b) / 2",
        "Half the sum of the components, at most 255 (glpng: PNG_BLEND2)."),
    row(Transparency::Blend3, "blend3", "a = (r + g + b) / 3",
        "The average of the components: only white is opaque (glpng: PNG_BLEND3)."),
    row(Transparency::Blend4, "blend4", "a = r² + g² + b²",
        "The sum of the squares of the components 0 to 255, at most 255: opaque but for almost black "
        "(glpng: PNG_BLEND4)."),
    row(Transparency::Blend5, "blend5", "a = (r² + g² + b²) / 2",
        "Half the sum of the squares of the components, at most 255 (glpng: PNG_BLEND5)."),
    row(Transparency::Blend6, "blend6", "a = (r² + g² + b²) / 3",
        "A third of the sum of the squares of the components, at most 255 (glpng: PNG_BLEND6)."),
    row(Transparency::Blend7, "blend7", "a = (r² + g² + b²) / 4",
        "A quarter of the sum of the squares of the components, at most 255 (glpng: PNG_BLEND7)."),
    row(Transparency::Blend8, "blend8", "a = sqrt(r² + g² + b²)",
        "The length of the colour as a vector, at most 255 (glpng: PNG_BLEND8)."),
};

template<>
struct EnumTable<Transparency> {
    static constexpr std::span<const EnumRow> rows = transparencyRows;
};

static_assert(transparencyRows.size() == 12);

/// Returns the image with the alpha of a choice. Colours stay, even if they become invisible.
/// - File: unchanged. Solid: Rgba8 becomes Rgb8, LuminanceAlpha8 becomes Luminance8.
/// - All others: Rgb8 becomes Rgba8, Luminance8 becomes LuminanceAlpha8 (its red, green and blue are equal).
/// - `stencil` is the colour that Stencil makes invisible: red, green, blue.
/// The formulas work on the numbers 0 to 255, as in glpng: they round down and clamp at 255. (glpng's header
/// defines Blend7 as a quarter and Blend8 as the root; some of its releases computed the root for Blend7.
/// Here the header is followed.) An image of alpha alone has no colours and is returned unchanged.
[[nodiscard]] Image applyTransparency(Image image, Transparency choice,
                                      std::array<std::uint8_t, 3> stencil = {0, 0, 0});

} // namespace texplorer
