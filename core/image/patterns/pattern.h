#pragma once

// Procedural images, bottom row first.

#include "texplorer/gl/enum_row.h"
#include "texplorer/image/image.h"

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
        "The 64 × 64 black and white board of checker.c in the OpenGL Programming Guide."),
    row(Pattern::CheckerRed, "checker-red", "Checkerboard, red",
        "The second, red board of texbind.c, with squares of twice the size."),
    row(Pattern::UvTemplate, "uv-template", "UV template",
        "A labelled grid. Each cell shows its s and t, and arrows show in which direction they grow."),
    row(Pattern::Brick, "brick", "Brick wall", "Bricks with mortar, which tile without a seam."),
    row(Pattern::BrickHeight, "brick-height", "Brick height map",
        "The heights of the brick wall as grey, from black (low) to white (high)."),
    row(Pattern::ColorLine, "color-line", "Colour line",
        "Eight colours in a row: a one-dimensional texture."),
    row(Pattern::Tree, "tree", "Tree", "A tree with a transparent background, for alpha test and blending."),
    row(Pattern::MipColors, "mip-colors", "Coloured mip levels",
        "Every mip level has its own colour, which shows the sampled level."),
    row(Pattern::Marble, "marble", "Marble volume",
        "A block of veined marble, 32 × 32 × 32 texels, for 3D textures."),
    row(Pattern::CubeFaces, "cube-faces", "Cube faces",
        "Six named faces in different colours, as an unfolded cube, for cube maps."),
    row(Pattern::Planet, "planet", "Planet", "A map of seas and lands from pole to pole, for a sphere."),
    row(Pattern::MirrorBall, "mirror-ball", "Mirror ball",
        "Sky and sand in a mirror ball, for GL_SPHERE_MAP."),
    row(Pattern::LogoOpenGl, "logo-opengl", "OpenGL plate",
        "A half transparent plate with the word OpenGL, for blending."),
    row(Pattern::LogoMultitexture, "logo-multitexture", "Multitexture plate",
        "Another plate, for the use of several texture units."),
    row(Pattern::Gradient, "gradient", "Colour gradient",
        "Red grows to the right, green grows upwards and blue fades. Formats of few bits show bands."),
};

template<>
struct EnumTable<Pattern> {
    static constexpr std::span<const EnumRow> rows = patternRows;
};

static_assert(patternRows.size() == 15);

/// Draws the base level of a pattern as Rgba8. The bytes are the same at every call and on every machine.
[[nodiscard]] Image drawPattern(Pattern pattern);

} // namespace texplorer
