#pragma once

// Texture coordinates from positions alone, as modelling programs project them.

#include "core/scene/scene.h"

#include <cstddef>
#include <span>

namespace texplorer {

enum class CoordProjection : std::uint32_t { Planar, Box, Spherical, Cylindrical };

inline constexpr std::array coordProjectionRows{
    row(CoordProjection::Planar, "planar", "Planar",
        "Along z: s and t are x and y, from 0 to 1 across the mesh, as a slide is projected."),
    row(CoordProjection::Box, "box", "Box",
        "Each vertex along the axis that its normal points along most: six slides, one for each side."),
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

/// `coords` with those of `vertices` projected anew; r becomes 0 and q 1. Both are those of the mesh. What is
/// projected is as large as the box around the whole mesh; along an axis without extent it is 0. Longitude
/// and latitude are about the origin, or where that lies beyond the box, about its middle.
///
/// The box gives the cube's own coordinates, the sphere the sphere's, the cylinder the cylinder's. Longitudes
/// are 0.5 at the front (+z) and grow eastwards. Where a mesh has a seam with vertices of its own on both
/// sides, s goes on beyond it, to 1 and further; across vertices that both sides share it can't. Where a
/// position has no longitude, as at a pole, the mesh's own s stays if it lies between those around it, else
/// it is their mean.
[[nodiscard]] TexCoords projectedTexCoords(const Mesh& mesh, CoordProjection projection,
                                           std::span<const std::size_t> vertices, TexCoords coords);

} // namespace texplorer
