#include "texplorer/mesh/shapes.h"

#include <cmath>

namespace texplorer {

namespace {

/// A sector, in degrees clockwise from the top.
struct Sector {
    double start;
    double sweep; ///< 0 to 360
};

// Backwards around it is the same sector. Too far around is once around, forwards in either case, as in GLU.
Sector sectorOf(const ShapeOptions& options) {
    const double start = options.startAngle;
    const double sweep = options.sweepAngle;
    if (std::abs(sweep) > 360)
        return {start, 360};
    return sweep < 0 ? Sector{start + sweep, -sweep} : Sector{start, sweep};
}

void addCentreFan(Mesh& mesh, int slices, int ring) {
    const std::uint32_t length = static_cast<std::uint32_t>(slices) + 1;
    const std::uint32_t outer = static_cast<std::uint32_t>(ring) * length;
    for (std::uint32_t i = 0; i + 1 < length; ++i)
        addTriangle(mesh, outer + length + i, outer + i, outer + i + 1);
}

} // namespace

Mesh makeDisk(float innerRadius, int slices, int rings) {
    return makePartialDisk({.shape = Shape::Disk,
                            .slices = slices,
                            .stacks = rings,
                            .innerRadius = innerRadius,
                            .startAngle = 0,
                            .sweepAngle = 360});
}

// gluPartialDisk with the outer radius 1. Vertices lie in rows from the rim inwards, each counter-clockwise
// from the sector's end to its start; the centre, where there is one, has as many as the rim.
Mesh makePartialDisk(const ShapeOptions& options) {
    Mesh mesh;
    const int slices = options.slices;
    const int rings = options.stacks;
    mesh.vertices.reserve(static_cast<std::size_t>(slices + 1) * static_cast<std::size_t>(rings + 1));
    const Sector sector = sectorOf(options);
    for (int ring = 0; ring <= rings; ++ring) {
        const float share = static_cast<float>(ring) / static_cast<float>(rings);
        const float radius = 1 + share * (options.innerRadius - 1);
        for (int slice = slices; slice >= 0; --slice) {
            const int step = sector.sweep == 360 ? slice % slices : slice; // a whole disk has no gap
            const Circle angle = circleAt((sector.start + sector.sweep * step / slices) / 90);
            mesh.vertices.push_back(
                {{radius * angle.sine, radius * angle.cosine, 0},
                 {0, 0, 1},
                 {radius / 2 * angle.sine + 0.5F, radius / 2 * angle.cosine + 0.5F, 0, 1}});
        }
    }

    addBandFaces(mesh, N_("Ring"), slices, 0, rings);
    // Around a centre GLU draws a GL_TRIANGLE_FAN, before everything else and counter-clockwise.
    const bool hole = options.innerRadius > 0;
    if (!hole)
        addCentreFan(mesh, slices, rings - 1);
    for (int ring = 0; ring < (hole ? rings : rings - 1); ++ring)
        addBandQuads(mesh, slices, ring);
    return mesh;
}

} // namespace texplorer
