#include "texplorer/reference/raster/assembly.h"

#include <algorithm>

namespace texplorer::reference {

namespace {

ShadedVertex withColorsOf(const ShadedVertex& colored, ShadedVertex vertex) {
    vertex.primary = colored.primary;
    vertex.secondary = colored.secondary;
    vertex.back = colored.back;
    return vertex;
}

} // namespace

void Assembly::add(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const {
    if (pass_.flat) // section 2.14.7: the colours of the last vertex
        addClipped(withColorsOf(c, a), withColorsOf(c, b), c);
    else
        addClipped(a, b, c);
}

void Assembly::add(const ShadedVertex& a, const ShadedVertex& b) const {
    const Polygon line = clipLine(pass_.flat ? withColorsOf(b, a) : a, b, pass_.perspective);
    if (line.size() != 2)
        return;
    if (const auto made = setUpLine(line[0], line[1], model_.lineWidth, pass_, viewport_, pass_.perspective))
        work_(*made);
}

void Assembly::add(const ShadedVertex& a) const {
    if (!isInView(a))
        return;
    if (const auto made = setUpPoint(a, model_.pointSize, pass_, viewport_, pass_.perspective))
        work_(*made);
}

void Assembly::add(std::span<const ShadedVertex> corners) const {
    if (corners.size() == 3)
        add(corners[0], corners[1], corners[2]);
    else if (corners.size() == 2)
        add(corners[0], corners[1]);
    else if (corners.size() == 1)
        add(corners[0]);
}

void Assembly::addClipped(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const {
    if (isInside(a, b, c))
        return addTriangle(a, b, c);
    Polygon polygon = clip(a, b, c, pass_.perspective);
    // Whichever corner of the triangle came first, it falls apart into the same ones.
    const auto isBefore = [](const ShadedVertex& one, const ShadedVertex& other) {
        return std::lexicographical_compare(&one.clip.x, &one.clip.x + 4, &other.clip.x, &other.clip.x + 4);
    };
    std::rotate(polygon.begin(), std::ranges::min_element(polygon, isBefore), polygon.end());
    for (std::size_t i = 2; i < polygon.size(); ++i)
        addTriangle(polygon[0], polygon[i - 1], polygon[i]);
}

void Assembly::addTriangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const {
    if (const auto triangle = setUp(a, b, c, pass_, viewport_, pass_.perspective))
        work_(*triangle);
}

} // namespace texplorer::reference
