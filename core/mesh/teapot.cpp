#include "texplorer/mesh/shapes.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <span>

namespace texplorer {

namespace {

// The 32 bicubic Bézier patches of M. Newell ("The Utilization of Procedure Models in Digital Image
// Synthesis", University of Utah, 1975), in his own units: 3.15 high, the handle towards -x, the spout
// towards +x. Each control row goes once around its part, and four of them make a ring of patches, the last
// of which is the first of the next ring's.

using Arc = std::array<glm::dvec3, 4>; ///< control points of a curve, which is a part of a row

/// Four quarter turns around the axis: control points (radius, 0), (radius, reach), (reach, radius), (0,
/// radius).
struct TurnedRow {
    double radius;
    double reach;
    double height;

    static constexpr int arcs = 4;

    Arc arc(int number) const {
        constexpr std::array<glm::dvec3, 5> ways{glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0),
                                                 glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
                                                 glm::dvec3(0, 0, -1)};
        const glm::dvec3 from = ways.at(static_cast<std::size_t>(number));
        const glm::dvec3 to = ways.at(static_cast<std::size_t>(number) + 1);
        const glm::dvec3 up(0, height, 0);
        return {from * radius + up, from * radius + to * reach + up, from * reach + to * radius + up,
                to * radius + up};
    }
};

/// Around a tube that is bent in the plane z = 0: its front half, then its back half.
struct TubeRow {
    double innerX;
    double innerHeight;
    double outerX;
    double outerHeight;
    double halfWidth;

    static constexpr int arcs = 2;

    Arc arc(int number) const {
        const glm::dvec3 inner(innerX, innerHeight, 0);
        const glm::dvec3 outer(outerX, outerHeight, 0);
        const glm::dvec3 front(0, 0, halfWidth);
        return number == 0 ? Arc{inner, inner + front, outer + front, outer}
                           : Arc{outer, outer - front, inner - front, inner};
    }
};

constexpr std::array bodyRows{
    TurnedRow{0, 0, 0},         TurnedRow{1.425, 0.798, 0},        TurnedRow{1.5, 0.84, 0.075},
    TurnedRow{1.5, 0.84, 0.15}, TurnedRow{1.5, 0.84, 0.225},       TurnedRow{2, 1.12, 0.45},
    TurnedRow{2, 1.12, 0.9},    TurnedRow{2, 1.12, 1.35},          TurnedRow{1.75, 0.98, 1.875},
    TurnedRow{1.5, 0.84, 2.4},  TurnedRow{1.4375, 0.805, 2.53125}, TurnedRow{1.3375, 0.749, 2.53125},
    TurnedRow{1.4, 0.784, 2.4},
};
constexpr std::array lidRows{
    TurnedRow{1.3, 0.728, 2.4}, TurnedRow{1.3, 0.728, 2.55}, TurnedRow{0.4, 0.224, 2.55},
    TurnedRow{0.2, 0.112, 2.7}, TurnedRow{0, 0, 2.85},       TurnedRow{0.8, 0.45, 3.15},
    TurnedRow{0, 0, 3.15},
};
constexpr std::array handleRows{
    TubeRow{-1.6, 2.025, -1.5, 2.25, 0.3}, TubeRow{-2.3, 2.025, -2.5, 2.25, 0.3},
    TubeRow{-2.7, 2.025, -3, 2.25, 0.3},   TubeRow{-2.7, 1.8, -3, 1.8, 0.3},
    TubeRow{-2.7, 1.575, -3, 1.35, 0.3},   TubeRow{-2.5, 1.125, -2.65, 0.9375, 0.3},
    TubeRow{-2, 0.9, -1.9, 0.6, 0.3},
};
constexpr std::array spoutRows{
    TubeRow{1.7, 1.425, 1.7, 0.6, 0.66},       TubeRow{2.6, 1.425, 3.1, 0.825, 0.66},
    TubeRow{2.3, 2.1, 2.4, 2.025, 0.25},       TubeRow{2.7, 2.4, 3.3, 2.4, 0.25},
    TubeRow{2.8, 2.475, 3.525, 2.49375, 0.25}, TubeRow{2.9, 2.475, 3.45, 2.5125, 0.15},
    TubeRow{2.8, 2.4, 3.2, 2.4, 0.15},
};

// t where each ring of patches ends: about as the outline's length has it.
constexpr std::array bodyEnds{0.0, 0.3, 0.5, 0.9, 1.0};
constexpr std::array lidEnds{0.0, 0.6, 1.0};
constexpr std::array tubeEnds{0.0, 0.5, 1.0};

// std::lerp is exact at both ends and between equal numbers: poles are points, and seams have no gap.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) {
    return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share), std::lerp(a.z, b.z, share)};
}

struct CurvePoint {
    glm::dvec3 position;
    glm::dvec3 way; ///< a third of the derivative
};

/// De Casteljau's construction.
CurvePoint pointOf(const Arc& curve, double share) {
    const glm::dvec3 a = between(curve[0], curve[1], share);
    const glm::dvec3 b = between(curve[1], curve[2], share);
    const glm::dvec3 c = between(curve[2], curve[3], share);
    const glm::dvec3 ab = between(a, b, share);
    const glm::dvec3 bc = between(b, c, share);
    return {between(ab, bc, share), bc - ab};
}

/// What is left of a patch at one height of it: a curve around the part, and how its control points go on.
struct Section {
    Arc places;
    Arc ways;
};

template<class Row>
Section sectionOf(std::span<const Row, 4> rows, int arc, double share) {
    Section section{};
    for (std::size_t column = 0; column < 4; ++column) {
        const CurvePoint point = pointOf({rows[0].arc(arc)[column], rows[1].arc(arc)[column],
                                          rows[2].arc(arc)[column], rows[3].arc(arc)[column]},
                                         share);
        section.places[column] = point.position;
        section.ways[column] = point.way;
    }
    return section;
}

/// At a pole the row is a point and shows no direction around the part: that of the adjacent rows is used.
glm::dvec3 normalOf(const glm::dvec3& around, const CurvePoint& onwards, double share) {
    if (around != glm::dvec3(0))
        return glm::normalize(glm::cross(around, onwards.position));
    return glm::normalize(glm::cross(share < 1 ? onwards.way : -onwards.way, onwards.position));
}

template<class Row>
void addRow(Mesh& mesh, std::span<const Row, 4> rows, double share, double t, int slices) {
    std::array<Section, Row::arcs> sections;
    for (int arc = 0; arc < Row::arcs; ++arc)
        sections.at(static_cast<std::size_t>(arc)) = sectionOf(rows, arc, share);
    for (int slice = 0; slice <= slices; ++slice) {
        const int along = slice % slices * Row::arcs;
        const Section& section = sections.at(static_cast<std::size_t>(along / slices));
        const double rest = static_cast<double>(along % slices) / slices;
        const CurvePoint point = pointOf(section.places, rest);
        const glm::dvec3 place = (point.position - glm::dvec3(0, 1.5, 0)) / 2.0;
        const float s = static_cast<float>(slice) / static_cast<float>(slices);
        mesh.vertices.push_back({glm::vec3(place),
                                 glm::vec3(normalOf(point.way, pointOf(section.ways, rest), share)),
                                 {s, static_cast<float>(t), 0, 1}});
    }
}

template<class Row>
void addPart(Mesh& mesh, const char* name, std::span<const Row> rows, std::span<const double> ends,
             int slices, int stacks) {
    const int firstRow = static_cast<int>(mesh.vertices.size()) / (slices + 1);
    const std::size_t rings = ends.size() - 1;
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const auto patches = rows.subspan(3 * ring).template first<4>();
        const int last = ring + 1 == rings ? stacks : stacks - 1; // which is the next ring's first
        for (int stack = 0; stack <= last; ++stack) {
            const double share = static_cast<double>(stack) / stacks;
            addRow(mesh, patches, share, std::lerp(ends[ring], ends[ring + 1], share), slices);
        }
    }
    const int bands = stacks * static_cast<int>(rings);
    addBandFaces(mesh, name, slices, firstRow, bands);
    for (int band = 0; band < bands; ++band)
        addBandQuads(mesh, slices, firstRow + band);
}

} // namespace

// Half as big and lowered by 0.75, as glutSolidTeapot(1) draws it. Vertices lie in rows around each part; its
// seam has two of them, a pole one for each s.
Mesh makeTeapot(int slices, int stacks) {
    Mesh mesh;
    mesh.vertices.reserve(static_cast<std::size_t>(slices + 1) * static_cast<std::size_t>(10 * stacks + 4));
    addPart<TurnedRow>(mesh, N_("Body"), bodyRows, bodyEnds, slices, stacks);
    addPart<TurnedRow>(mesh, N_("Lid"), lidRows, lidEnds, slices, stacks);
    addPart<TubeRow>(mesh, N_("Handle"), handleRows, tubeEnds, slices, stacks);
    addPart<TubeRow>(mesh, N_("Spout"), spoutRows, tubeEnds, slices, stacks);
    return mesh;
}

} // namespace texplorer
