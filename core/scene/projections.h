#pragma once

// Texture coordinates computed from positions, by the projections of modelling programs.

#include "texplorer/scene/scene.h"

#include <cstddef>
#include <span>

namespace texplorer {

enum class CoordProjection : std::uint32_t { Planar, Box, Spherical, Cylindrical };

inline constexpr std::array coordProjectionRows{
    row(CoordProjection::Planar, "planar", "Planar",
        "Along z: s and t are x and y, from 0 to 1 across the mesh, like a projected slide."),
    row(CoordProjection::Box, "box", "Box",
        "Each vertex along the main axis of its normal: six slides, one for each side."),
    row(CoordProjection::Spherical, "spherical", "Spherical",
        "s is the longitude about the y axis, t the latitude: from 0 to 1 around and from pole to pole."),
    row(CoordProjection::Cylindrical, "cylindrical", "Cylindrical",
        "s is the longitude about the y axis, t the height from 0 to 1."),
};

template<>
struct EnumTable<CoordProjection> {
    static constexpr std::span<const EnumRow> rows = coordProjectionRows;
};

static_assert(coordProjectionRows.size() == 4);

/// Returns `coords` with those of `vertices` replaced by a projection; r becomes 0 and q 1. Both belong to
/// the mesh. The projection covers the bounding box of the whole mesh; along an axis without extent, the
/// coordinate is 0. Longitude and latitude are relative to the origin, or to the centre of the box if the
/// origin is outside.
///
/// The box projection gives the cube's own coordinates, the sphere the sphere's, the cylinder the cylinder's.
/// Longitudes are 0.5 at the front (+z) and grow eastwards. At a seam with separate vertices on both sides, s
/// continues to 1 and beyond; across shared vertices it cannot. If a position has no longitude, as at a pole,
/// the mesh's own s stays if it is between those around it, else it is their mean.
[[nodiscard]] TexCoords projectedTexCoords(const Mesh& mesh, CoordProjection projection,
                                           std::span<const std::size_t> vertices, TexCoords coords);

} // namespace texplorer
