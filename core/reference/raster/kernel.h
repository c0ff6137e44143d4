#pragma once

// Fragments of a whole picture: the same bytes as shade.h and raster.cpp's literal fragment, which are the
// text to read, for several pixels of a row at a time.
//
// lanes.inl, sample.inl and shade.inl are the program. It is compiled once for each length of
// vectors that a processor may have (four_lanes.cpp, eight_lanes.cpp); which one is used is decided at run
// time.

#include "core/reference/raster/triangle.h"
#include "core/reference/sampling/fast_sampler.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace texplorer::reference {

/// How many pixels are drawn together at most.
inline constexpr int rowCapacity = SampleRow::capacity;

/// Neighbouring pixels of one row of the picture, and where they are kept.
struct PixelRow {
    int x; ///< of the first
    int y;
    int count;            ///< 1 to rowCapacity
    std::uint32_t* depth; ///< 24 bits each
    std::byte* colors;    ///< four bytes each
};

/// Whole vectors are read and written: so many pixels beyond the end of a row, at most, are written as they
/// were.
inline constexpr int rowSlack = 8;

inline constexpr std::uint32_t noTriangle = ~0U; ///< owns a pixel that no triangle covers

struct Kernel {
    int lanes; ///< how many pixels are computed at once

    /// The colours of the first `count` places (at most SampleRow::capacity). Room for as many, rounded up to
    /// a multiple of `lanes`.
    void (*sample)(const FastSampler& sampler, const SampleRow& row, int count, glm::vec4* colors);

    /// Draws pixels of a triangle: depth test, texturing, colour sum, fog, alpha test, blending.
    void (*draw)(const Triangle& triangle, const PixelRow& row);

    /// The same in two steps, for passes that neither blend nor test alpha: first the depth test alone, which
    /// puts `number` where it succeeds. When all triangles have been marked, what a pixel was given last owns
    /// it, and no hidden pixel is ever shaded.
    void (*mark)(const Triangle& triangle, std::uint32_t number, const PixelRow& row, std::uint32_t* owners);
    void (*shade)(std::span<const Triangle> triangles, const std::uint32_t* owners, const PixelRow& row);
};

/// Of all lengths that this processor has, the longest first. Never empty.
[[nodiscard]] std::span<const Kernel* const> kernels();

/// What kernels() is made of: for every processor; with AVX2, nullptr where it is missing.
[[nodiscard]] const Kernel* fourLanes();
[[nodiscard]] const Kernel* eightLanes();

} // namespace texplorer::reference
