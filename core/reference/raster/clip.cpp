#include "core/reference/shading/vertex.h"

#include <glm/common.hpp>

#include <cmath>

namespace texplorer::reference {

namespace {

bool isFinite(glm::vec4 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// How far a vertex is inside of a plane, negative outside: w - x for the right one.
float distance(const glm::vec4& plane, const glm::vec4& clip) {
    return plane.x * clip.x + plane.y * clip.y + plane.z * clip.z + plane.w * clip.w;
}

/// Where `made` lies between two others as the window shows them.
float shareInWindow(const glm::vec4& from, const glm::vec4& to, const glm::vec4& made, float otherwise) {
    for (int axis = 0; axis < 2; ++axis) {
        const float length = to[axis] / to.w - from[axis] / from.w;
        const float share = (made[axis] / made.w - from[axis] / from.w) / length;
        if (from[axis] != to[axis] && std::isfinite(share))
            return share;
    }
    return otherwise;
}

/// Section 2.14.8: colours and coordinates are clipped along with the position.
ShadedVertex between(const ShadedVertex& from, const ShadedVertex& to, float t, bool perspective) {
    ShadedVertex made;
    made.clip = glm::mix(from.clip, to.clip, t);
    if (!perspective)
        t = shareInWindow(from.clip, to.clip, made.clip, t);
    made.primary = glm::mix(from.primary, to.primary, t);
    made.secondary = glm::mix(from.secondary, to.secondary, t);
    for (std::size_t unit = 0; unit < made.texCoords.size(); ++unit)
        made.texCoords[unit] = glm::mix(from.texCoords[unit], to.texCoords[unit], t);
    made.back.primary = glm::mix(from.back.primary, to.back.primary, t);
    made.back.secondary = glm::mix(from.back.secondary, to.back.secondary, t);
    made.fogDistance = glm::mix(from.fogDistance, to.fogDistance, t);
    return made;
}

Polygon cut(const Polygon& polygon, const glm::vec4& plane, bool perspective) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ShadedVertex& from = polygon[i];
        const ShadedVertex& to = polygon[(i + 1) % polygon.size()];
        const float a = distance(plane, from.clip);
        const float b = distance(plane, to.clip);
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
constexpr std::array<glm::vec4, 6> planesAt(float band) {
    return {glm::vec4(0, 0, 1, 1),     glm::vec4(0, 0, -1, 1),   glm::vec4(1, 0, 0, band),
            glm::vec4(-1, 0, 0, band), glm::vec4(0, 1, 0, band), glm::vec4(0, -1, 0, band)};
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
    for (const glm::vec4& plane : planes) {
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
    for (const glm::vec4& plane : viewPlanes) { // a wide line outside of the view doesn't reach into it
        const float from = distance(plane, line[0].clip);
        const float to = distance(plane, line[1].clip);
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
        for (const glm::vec4& plane : planes) {
            if (!(distance(plane, vertex->clip) >= 0))
                return false;
        }
    }
    return true;
}

} // namespace texplorer::reference
