#include "texplorer/reference/shading/vertex.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace texplorer::reference {

namespace {

bool isFinite(glm::vec4 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// How far a vertex is inside of a plane, negative outside: w - x for the right one. A float's range is too
/// small for the sum: vertices may be as far away as it goes.
double distance(const glm::dvec4& plane, const glm::dvec4& clip) {
    return glm::dot(plane, clip);
}

/// Where `made` lies between two others as the window shows them.
double shareInWindow(const glm::dvec4& from, const glm::dvec4& to, const glm::dvec4& made, double otherwise) {
    for (int axis = 0; axis < 2; ++axis) {
        const double length = to[axis] / to.w - from[axis] / from.w;
        const double share = (made[axis] / made.w - from[axis] / from.w) / length;
        if (from[axis] != to[axis] && std::isfinite(share))
            return share;
    }
    return otherwise;
}

/// Section 2.14.8: colours and coordinates are clipped along with the position.
ShadedVertex between(const ShadedVertex& from, const ShadedVertex& to, double t, bool perspective) {
    ShadedVertex made;
    const auto clip = glm::mix(glm::dvec4(from.clip), glm::dvec4(to.clip), t);
    made.clip = glm::vec4(clip);
    if (!perspective)
        t = shareInWindow(from.clip, to.clip, clip, t);
    const auto share = static_cast<float>(t);
    made.primary = glm::mix(from.primary, to.primary, share);
    made.secondary = glm::mix(from.secondary, to.secondary, share);
    for (std::size_t unit = 0; unit < made.texCoords.size(); ++unit)
        made.texCoords[unit] =
            glm::vec4(glm::mix(glm::dvec4(from.texCoords[unit]), glm::dvec4(to.texCoords[unit]), t));
    made.back.primary = glm::mix(from.back.primary, to.back.primary, share);
    made.back.secondary = glm::mix(from.back.secondary, to.back.secondary, share);
    made.fogDistance = static_cast<float>(glm::mix(double{from.fogDistance}, double{to.fogDistance}, t));
    return made;
}

Polygon cut(const Polygon& polygon, const glm::dvec4& plane, bool perspective) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ShadedVertex& from = polygon[i];
        const ShadedVertex& to = polygon[(i + 1) % polygon.size()];
        const double a = distance(plane, from.clip);
        const double b = distance(plane, to.clip);
        if (a >= 0)
            kept.push_back(from);
        // From the inside outwards, whichever way the edge runs: two triangles that share it get the same
        // point.
        if (a >= 0 && b < 0)
            kept.push_back(between(from, to, a / (a - b), perspective));
        else if (a < 0 && b >= 0)
            kept.push_back(between(to, from, b / (b - a), perspective));
    }
    return kept;
}

// -w <= z <= w leaves no negative w.
constexpr std::array<glm::dvec4, 6> planesAt(double band) {
    return {glm::dvec4(0, 0, 1, 1),     glm::dvec4(0, 0, -1, 1),   glm::dvec4(1, 0, 0, band),
            glm::dvec4(-1, 0, 0, band), glm::dvec4(0, 1, 0, band), glm::dvec4(0, -1, 0, band)};
}
constexpr std::array planes = planesAt(guardBand);
constexpr std::array viewPlanes = planesAt(1);

} // namespace

Polygon clip(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c, bool perspective) {
    Polygon polygon{a, b, c};
    for (const ShadedVertex& vertex : polygon) {
        if (!isFinite(vertex.clip))
            return {};
    }
    for (const glm::dvec4& plane : planes) {
        bool crosses = false;
        for (const ShadedVertex& vertex : polygon)
            crosses = crosses || distance(plane, vertex.clip) < 0;
        if (crosses)
            polygon = cut(polygon, plane, perspective);
    }
    for (const ShadedVertex& vertex : polygon) {
        if (!isFinite(vertex.clip) || !(vertex.clip.w > 0))
            return {};
    }
    return polygon.size() < 3 ? Polygon{} : polygon;
}

Polygon clipLine(const ShadedVertex& a, const ShadedVertex& b, bool perspective) {
    if (!isFinite(a.clip) || !isFinite(b.clip))
        return {};
    Polygon line{a, b};
    for (const glm::dvec4& plane : viewPlanes) { // a wide line outside of the view doesn't reach into it
        const double from = distance(plane, line[0].clip);
        const double to = distance(plane, line[1].clip);
        if (from < 0 && to < 0)
            return {};
        if (to < 0)
            line[1] = between(line[0], line[1], from / (from - to), perspective);
        else if (from < 0)
            line[0] = between(line[1], line[0], to / (to - from), perspective);
    }
    for (const ShadedVertex& vertex : line) {
        if (!isFinite(vertex.clip) || !(vertex.clip.w > 0))
            return {};
    }
    return line;
}

bool isInView(const ShadedVertex& vertex) {
    const glm::vec4& clip = vertex.clip;
    return isFinite(clip) && clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
           std::abs(clip.z) <= clip.w;
}

bool isInside(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) {
    for (const ShadedVertex* vertex : {&a, &b, &c}) {
        if (!isFinite(vertex->clip) || !(vertex->clip.w > 0))
            return false;
        for (const glm::dvec4& plane : planes) {
            if (!(distance(plane, vertex->clip) >= 0))
                return false;
        }
    }
    return true;
}

} // namespace texplorer::reference
