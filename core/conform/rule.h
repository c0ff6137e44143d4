#pragma once

// How far two renderers may be apart, and why: a row for each reason, never one number for everything.

#include <cstdint>
#include <string_view>

namespace texplorer::conform {

/// What a driver may do otherwise without being wrong, because the specification leaves it open or its
/// arithmetic has only so many bits. A pixel that differs is then compared with what the reference draws at
/// both ends of that freedom.
enum class Tolerance : std::uint8_t {
    None,
    /// Coordinates within 1/128 of a texel, or 2^-20 of themselves: next to an edge either of two texels is
    /// right.
    TexelEdge,
    /// rho within the range of OpenGL 2.1, section 3.8.8, and lambda within its error at this pixel
    /// (lambda_range.h), or coordinates as above: where levels are blended, the colour lies between those
    /// that lambda spans; where one is chosen, it is that of one.
    Lambda,
};

struct Rule {
    std::string_view name;
    int bound;    ///< of a component, in 255ths: a pixel that differs by more is over
    double share; ///< of the pixels of all scenes that must not be over: of thousands (sample_limit.h)
    Tolerance tolerance;
    double explained; ///< of the pixels of all scenes, what must not be over once the tolerance is granted
    double explainedScene; ///< the same of the pixels of any single scene: none may be altogether wrong
    std::string_view reason;
    int farBound = 255;   ///< a pixel that differs by more is far, whatever may be granted; 255: none is
    double nearScene = 1; ///< of the pixels of any single scene, what must not be far
};

namespace rules {

inline constexpr Rule exact{
    "exact",
    1,
    1,
    Tolerance::None,
    1,
    1,
    "The specification says every step, and no coordinate comes near to the edge of a texel: what is left is "
    "the rounding to 8 bits (OpenGL 2.1, section 2.14.9), which may go either way."};

inline constexpr Rule passes{
    "passes",
    3,
    1,
    Tolerance::None,
    1,
    1,
    "Each pass is rounded to 8 bits before the next one reads it, and rounding may go either way: one 255th "
    "for each of two or three passes (OpenGL 2.1, sections 2.14.9 and 4.1.8)."};

inline constexpr Rule blocks{
    "blocks",
    2,
    1,
    Tolerance::None,
    1,
    1,
    "EXT_texture_compression_s3tc gives the colours between two ends as fractions and leaves their rounding "
    "open; the picture is rounded once more."};

inline constexpr Rule texelEdge{
    "texel-edge",
    2,
    0.999,
    Tolerance::TexelEdge,
    0.9995,
    0.99,
    "Coordinates have so many bits: next to the edge of a texel either neighbour is right, and filter "
    "weights "
    "are off by as much. dEQP's texture lookup verifier grants 7 bits of a texel (uvwBits = 7). A corner may "
    "be snapped to another 256th of a pixel, and with it a pixel on the outline."};

inline constexpr Rule texelEdgeOnQuads{
    "texel-edge-quads",
    1,
    0.999,
    Tolerance::TexelEdge,
    1,
    1,
    "A flat quad that covers the picture has neither an outline nor lambda at stake, but generated "
    "coordinates are no round numbers: each pixel has the colour of a texel within 7 bits of its place "
    "(dEQP: "
    "uvwBits = 7)."};

inline constexpr Rule levelChoice{
    "level-choice",
    2,
    0.99,
    Tolerance::Lambda,
    0.9995,
    0.99,
    "Half-way between two levels, and between magnification and minification, the error of lambda decides "
    "which texels are taken. The specification leaves rho open within wide bounds (OpenGL 2.1, section "
    "3.8.8: "
    "max(m_u, m_v) <= f <= m_u + m_v). Granted are these, 6 bits of lambda, as dEQP does (lodBits = 6), and "
    "llvmpipe's own arithmetic: one derivative for 2 x 2 pixels, log2(rho^2) from the bits of a float."};

inline constexpr Rule levelBlend{
    "level-blend",
    2,
    0.96,
    Tolerance::Lambda,
    0.9995,
    0.99,
    "Between two levels the error of lambda shows as a colour, so GL's must lie among those that lambda "
    "spans "
    "at this pixel, with any rho that OpenGL 2.1, section 3.8.8, allows: 6 bits, as dEQP grants (lodBits = 6), "
    "and llvmpipe's own arithmetic, which takes one "
    "derivative for 2 x 2 pixels and log2(rho^2) from the bits of a float, at most 0.0861 too little. "
    "Because "
    "of that one, 96 % have to be within the bound and not 99 %."};

inline constexpr Rule foreignLevels{
    "foreign-levels",
    2,
    0.88,
    Tolerance::Lambda,
    0.9995,
    0.99,
    "As between two levels that are made of each other, but here neighbours have nothing in common: the same "
    "error of lambda moves a colour further, and only 88 % have to be within the bound."};

inline constexpr Rule ellipse{
    "ellipse",
    16,
    0.98,
    Tolerance::None,
    0.98,
    0.8,
    "EXT_texture_filter_anisotropic leaves the method open. The reference averages over an ellipse as Mesa "
    "does; but Mesa takes the axes of the ellipse from one derivative for 2 x 2 pixels and its weights from "
    "a "
    "table, so that colours are off by more than the bound along edges of the image. Towards the horizon it may "
    "take another level: of a floor that is seen from 8 to 20 degrees above, up to 16 % of the pixels are over "
    "then, but hardly any is off by more than half of what there is.",
    128,
    0.95};

inline constexpr Rule outline{
    "outline",
    1,
    0.9995,
    Tolerance::None,
    0.9995,
    0.99,
    "Which pixels a polygon covers is said for exact corners; they are snapped to 1/256 of a pixel "
    "(GL_SUBPIXEL_BITS), so that one on the outline may fall on the other side."};

inline constexpr Rule lines{
    "lines",
    2,
    0.9998,
    Tolerance::TexelEdge,
    0.9998,
    0.985,
    "Which pixels a line covers is said for exact ends; they are snapped to 1/256 of a pixel "
    "(GL_SUBPIXEL_BITS). Where a side of it, or of the diamond that it ends in, passes a pixel's centre as "
    "near, there is a pixel more or less (OpenGL 2.1, sections 3.4.1 and 3.4.2). Along a line of one pixel Mesa "
    "interpolates by its longer axis, while equation 3.5 projects the centre of the pixel on it: a quarter of "
    "a pixel at most."};

inline constexpr Rule lastBit{
    "last-bit",
    1,
    0.9999,
    Tolerance::None,
    0.9999,
    0.99,
    "Two vertex programs of one driver need not multiply in the same order, so that positions and "
    "coordinates may differ in their last bits: a corner is snapped otherwise, or a pixel on the edge of a "
    "texel gets its neighbour."};

} // namespace rules

} // namespace texplorer::conform
