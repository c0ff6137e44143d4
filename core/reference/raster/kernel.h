#pragma once

// Draws fragments of several pixels of a row at once. The bytes are the same as from shade.h and the literal
// fragment of raster.cpp, which are easier to read.
//
// lanes.inl, sample.inl and shade.inl are the source. It is compiled once for each vector length
// (four_lanes.cpp, eight_lanes.cpp); the one for the processor is chosen at run time.

#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/sampling/fast_sampler.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace texplorer::reference {

/// The maximum number of pixels that are drawn together.
inline constexpr int rowCapacity = SampleRow::capacity;

/// Adjacent pixels of a row of the picture, and their memory.
struct PixelRow {
    int x; ///< of the first
    int y;
    int count;            ///< 1 to rowCapacity
    std::uint32_t* depth; ///< 24 bits each
    std::byte* colors;    ///< four bytes each
};

/// Whole vectors are read and written: up to so many pixels after the end of a row are rewritten unchanged.
inline constexpr int rowSlack = 8;

inline constexpr std::uint32_t noTriangle = ~0U; ///< the owner of a pixel without a triangle

struct Kernel {
    int lanes; ///< number of pixels that are computed at once

    /// Computes the colours of the first `count` places (at most SampleRow::capacity). The output needs room
    /// for `count` rounded up to a multiple of `lanes`.
    void (*sample)(const FastSampler& sampler, const SampleRow& row, int count, glm::vec4* colors);

    /// Draws pixels of a triangle: depth test, texturing, colour sum, fog, alpha test, blending.
    void (*draw)(const Triangle& triangle, const PixelRow& row);

    /// The same in two steps, for passes without blending and alpha test: first the depth test alone, which
    /// writes `number` where it passes. When all triangles are marked, the last mark of a pixel is its owner,
    /// so hidden pixels are never shaded.
    void (*mark)(const Triangle& triangle, std::uint32_t number, const PixelRow& row, std::uint32_t* owners);
    void (*shade)(std::span<const Triangle> triangles, const std::uint32_t* owners, const PixelRow& row);
};

/// The kernels that this processor supports, the longest vectors first. Never empty.
[[nodiscard]] std::span<const Kernel* const> kernels();

/// The kernels: for every processor; and with AVX2, nullptr if it is missing.
[[nodiscard]] const Kernel* fourLanes();
[[nodiscard]] const Kernel* eightLanes();

} // namespace texplorer::reference
