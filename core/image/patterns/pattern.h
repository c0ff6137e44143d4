#pragma once

// Procedural images: textures that need no file. Each is drawn bottom row first.

#include "core/gl/enum_row.h"
#include "core/image/image.h"

namespace texplorer {

enum class Pattern : std::uint32_t {
    Checker,
    CheckerRed,
    UvTemplate,
    Brick,
    BrickHeight,
    ColorLine,
    Tree,
    MipColors,
    Marble,
    CubeFaces,
    Planet,
    MirrorBall,
    LogoOpenGl,
    LogoMultitexture,
    Gradient,
};

inline constexpr std::array patternRows{
    row(Pattern::Checker, "checker", "Checkerboard",
        "The 64 x 64 black and white board of checker.c in the OpenGL Programming Guide."),
    row(Pattern::CheckerRed, "checker-red", "Checkerboard, red",
        "The second, red board of texbind.c, with squares of twice the size."),
    row(Pattern::UvTemplate, "uv-template", "UV template",
        "A labelled grid: every cell names its s and t, arrows show which way both grow."),
    row(Pattern::Brick, "brick", "Brick wall", "Bricks with mortar; it tiles without a seam."),
    row(Pattern::BrickHeight, "brick-height", "Brick height map",
        "The heights of the brick wall as grey: white stands out, black lies deep."),
    row(Pattern::ColorLine, "color-line", "Colour line",
        "Eight colours in a row: a one-dimensional texture."),
    row(Pattern::Tree, "tree", "Tree",
        "A tree whose surroundings are transparent: for alpha test and blending."),
    row(Pattern::MipColors, "mip-colors", "Coloured mip levels",
        "Every mip level has a colour of its own, so that one sees which level is sampled."),
    row(Pattern::Marble, "marble", "Marble volume",
        "A block of veined marble, 32 x 32 x 32 texels: for 3D textures."),
    row(Pattern::CubeFaces, "cube-faces", "Cube faces",
        "Six named faces, each with a colour of its own, as an unfolded cube: for cube maps."),
    row(Pattern::Planet, "planet", "Planet", "A map of seas and lands from pole to pole: for a sphere."),
    row(Pattern::MirrorBall, "mirror-ball", "Mirror ball",
        "Sky and sand as a mirror ball shows them: for GL_SPHERE_MAP."),
    row(Pattern::LogoOpenGl, "logo-opengl", "OpenGL plate",
        "A plate with the word OpenGL that one half sees through: for blending."),
    row(Pattern::LogoMultitexture, "logo-multitexture", "Multitexture plate",
        "Another plate, for what is drawn with several texture units."),
    row(Pattern::Gradient, "gradient", "Colour gradient",
        "Red grows to the right, green upwards, and blue fades: what has few bits shows as bands."),
};

template<>
struct EnumTable<Pattern> {
    static constexpr std::span<const EnumRow> rows = patternRows;
};

static_assert(patternRows.size() == 15);

/// The base level of a pattern as Rgba8. The same bytes at every call, on every machine.
[[nodiscard]] Image drawPattern(Pattern pattern);

} // namespace texplorer
