#pragma once

// How much two renderers may differ, and why: a row for each reason, instead of one number for all.

#include <cstdint>
#include <string_view>

namespace texplorer::conform {

/// What a correct driver may do differently, because the specification leaves it open or its arithmetic has
/// limited precision. A pixel that differs is then compared with the reference's results at both ends of that
/// freedom.
enum class Tolerance : std::uint8_t {
    None,
    /// Coordinates may be off by 1/128 of a texel, or by 2^-20 of their value: next to an edge, either of two
    /// texels is right.
    TexelEdge,
    /// rho may be anywhere in the range of OpenGL 2.1, section 3.8.8, lambda may have its error at this pixel
    /// (lambda_range.h), and coordinates as above. If levels are blended, the colour must be between the
    /// colours that lambda allows; if one level is chosen, it must be the colour of one.
    Lambda,
};

struct Rule {
    std::string_view name;
    int bound; ///< of a component, in units of 1/255: a pixel that differs by more is over
    /// Of the pixels of all scenes: the share that must not be over; for thousands of scenes
    /// (sample_limit.h).
    double share;
    Tolerance tolerance;
    /// Of the pixels of all scenes: the share that must not be over or that the tolerance explains.
    double explained;
    /// The same for each single scene, so that no scene may be completely wrong.
    double explainedScene;
    std::string_view reason;
    int farBound = 255;   ///< a pixel that differs by more is far, regardless of the tolerance; 255: none is
    double nearScene = 1; ///< of the pixels of each single scene: the share that must not be far
};

namespace rules {

inline constexpr Rule exact{
    "exact",
    1,
    1,
    Tolerance::None,
    1,
    1,
    "The specification defines every step, and no coordinate is near the edge of a texel. Only the "
    "rounding to 8 bits (OpenGL 2.1, section 2.14.9) may differ."};

inline constexpr Rule passes{
    "passes",
    3,
    1,
    Tolerance::None,
    1,
    1,
    "Each pass is rounded to 8 bits before the next one reads it, and rounding may differ: one 255th for "
    "each of two or three passes (OpenGL 2.1, sections 2.14.9 and 4.1.8)."};

inline constexpr Rule blocks{
    "blocks",
    2,
    1,
    Tolerance::None,
    1,
    1,
    "EXT_texture_compression_s3tc defines the colours between two ends as fractions but not their "
    "rounding; the picture is rounded once more."};

inline constexpr Rule texelEdge{
    "texel-edge",
    2,
    0.999,
    Tolerance::TexelEdge,
    0.9995,
    0.99,
    "Coordinates have limited precision: next to the edge of a texel either neighbour is correct, and "
    "filter weights are off by as much. dEQP's texture lookup verifier grants 7 bits of a texel (uvwBits = "
    "7). A vertex may be snapped to another 256th of a pixel, which affects pixels on the outline."};

inline constexpr Rule texelEdgeOnQuads{
    "texel-edge-quads",
    1,
    0.999,
    Tolerance::TexelEdge,
    1,
    1,
    "A flat quad that covers the picture depends on neither an outline nor lambda, but generated "
    "coordinates are not round numbers: each pixel has the colour of a texel within 7 bits of its place "
    "(dEQP: uvwBits = 7)."};

inline constexpr Rule levelChoice{
    "level-choice",
    2,
    0.99,
    Tolerance::Lambda,
    0.9995,
    0.99,
    "Half-way between two levels, and between magnification and minification, the error of lambda decides "
    "which texels are read. The specification defines rho only within wide bounds (OpenGL 2.1, section "
    "3.8.8: max(m_u, m_v) <= f <= m_u + m_v). The rule grants these bounds, 6 bits of lambda, as dEQP "
    "(lodBits = 6), and llvmpipe's arithmetic: one derivative for 2 × 2 pixels, log2(rho^2) from the bits "
    "of a float."};

inline constexpr Rule levelBlend{
    "level-blend",
    2,
    0.96,
    Tolerance::Lambda,
    0.9995,
    0.99,
    "Between two levels the error of lambda shows as a colour, so GL's must be among those that lambda "
    "spans at this pixel, with any rho that OpenGL 2.1, section 3.8.8, allows: 6 bits, as dEQP grants "
    "(lodBits = 6), and llvmpipe's arithmetic, which uses one derivative for 2 × 2 pixels and log2(rho^2) "
    "from the bits of a float, at most 0.0861 too low. Because of the latter, 96 % have to be within the "
    "bound instead of 99 %."};

inline constexpr Rule foreignLevels{
    "foreign-levels",
    2,
    0.88,
    Tolerance::Lambda,
    0.9995,
    0.99,
    "As between two generated levels, but here neighbouring levels are unrelated: the same error of lambda "
    "changes a colour more, and only 88 % have to be within the bound."};

inline constexpr Rule ellipse{
    "ellipse",
    16,
    0.98,
    Tolerance::None,
    0.98,
    0.8,
    "EXT_texture_filter_anisotropic does not define the method. The reference averages over an ellipse "
    "like Mesa, but Mesa takes the axes of the ellipse from one derivative for 2 × 2 pixels and its "
    "weights from a table, so that colours are off by more than the bound along edges of the image. "
    "Towards the horizon it may use another level: for a floor seen from 8 to 20 degrees above, up to 16 % "
    "of the pixels are then over the bound, but hardly any differs by more than half of the range.",
    128,
    0.95};

inline constexpr Rule outline{
    "outline",
    1,
    0.9995,
    Tolerance::None,
    0.9995,
    0.99,
    "The pixels of a polygon are defined for exact vertices, but these are snapped to 1/256 of a pixel "
    "(GL_SUBPIXEL_BITS), so a pixel on the outline may be on the other side."};

inline constexpr Rule lines{
    "lines",
    2,
    0.9998,
    Tolerance::TexelEdge,
    0.9998,
    0.985,
    "The pixels of a line are defined for exact ends, but these are snapped to 1/256 of a pixel "
    "(GL_SUBPIXEL_BITS). Where one of its sides, or of the diamond at its end, is that near to a pixel's "
    "centre, there may be one pixel more or less (OpenGL 2.1, sections 3.4.1 and 3.4.2). Along a line of "
    "one pixel Mesa interpolates by its longer axis, while equation 3.5 projects the centre of the pixel "
    "on it: a quarter of a pixel at most."};

inline constexpr Rule lastBit{
    "last-bit",
    1,
    0.9999,
    Tolerance::None,
    0.9999,
    0.99,
    "Two vertex programs of a driver may multiply in different orders, so positions and coordinates may "
    "differ in their last bits: a vertex is snapped differently, or a pixel on the edge of a texel gets "
    "its neighbour."};

} // namespace rules

} // namespace texplorer::conform
