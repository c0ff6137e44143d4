// Lines and points: OpenGL 2.1, sections 3.3 and 3.4.

#include "texplorer/reference/raster/corner.h"
#include "texplorer/reference/shading/pass_state.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace texplorer::reference {

namespace {

constexpr std::int64_t half = subPixels / 2;

/// A position on the axis along which a line is longer, and on the other one.
struct Place {
    std::int64_t major;
    std::int64_t minor;
};

/// Which pixel a position belongs to. On the boundary it is the lower one: positions are thought of as moved
/// by less than anything to the left and, by still less, down (section 3.4.1).
std::int64_t pixelOf(std::int64_t snapped) {
    return pixelAtOrAfter(snapped - half);
}

/// Whether a position lies in the diamond around the centre of its pixel. Of those on the boundary, the ones
/// to the right of the centre do, as they are thought of as moved to the left.
bool isInDiamond(Place place, std::int64_t pixel, bool xMajor) {
    const std::int64_t along = place.major - pixel * subPixels;
    const std::int64_t across = place.minor - pixelOf(place.minor) * subPixels;
    const std::int64_t distance = std::abs(along) + std::abs(across);
    return distance < half || (distance == half && (xMajor ? along : across) > 0);
}

/// The first and last pixel along a line. It has one wherever it crosses the middle of a column (of a row, if
/// it is y-major), and one more where it leaves the diamond that it begins in; none where it ends in it.
std::pair<std::int64_t, std::int64_t> pixelsAlong(Place from, Place to, bool xMajor) {
    const bool forward = from.major <= to.major;
    const Place low = forward ? from : to;
    const Place high = forward ? to : from;
    std::int64_t first = pixelAtOrAfter(low.major);
    std::int64_t last = pixelAtOrAfter(high.major) - 1;
    if (forward) {
        first -= isInDiamond(low, first - 1, xMajor) ? 1 : 0;
        last -= isInDiamond(high, last, xMajor) ? 1 : 0;
    } else {
        first += isInDiamond(low, first, xMajor) ? 1 : 0;
        last += isInDiamond(high, last + 1, xMajor) ? 1 : 0;
    }
    return {first, last};
}

/// How far along the line a position is, 0 to 1, by x and by y: equation 3.5. The pixels of a wide line's
/// column are copies of one another (section 3.4.2), so there only the longer axis counts.
glm::dvec2 gradientOf(glm::dvec2 direction, bool wide, bool xMajor) {
    const double length = glm::dot(direction, direction);
    if (length == 0)
        return glm::dvec2(0);
    if (!wide)
        return direction / length;
    return xMajor ? glm::dvec2(1 / direction.x, 0) : glm::dvec2(0, 1 / direction.y);
}

/// What is interpolated is that of one corner, and changes by `gradient` times the difference to the other.
void setPlanes(Triangle& line, const Corner& from, const Corner& to, glm::dvec2 gradient,
               const PassState& pass) {
    const auto plane = [&]<class T>(auto a, auto b) {
        return Plane<T>{T(a), T((b - a) * gradient.x), T((b - a) * gradient.y)};
    };
    const auto overW = [&](auto member) {
        return plane.template operator()<glm::vec4>(glm::dvec4(member(*from.vertex)) * from.invW,
                                                    glm::dvec4(member(*to.vertex)) * to.invW);
    };
    line.pass = &pass;
    line.origin = glm::vec2(from.window);
    line.depth = plane.operator()<float>(from.depth, to.depth);
    line.invW = plane.operator()<float>(from.invW, to.invW);
    line.primary = overW([](const ShadedVertex& v) { return v.primary; });
    if (from.vertex->primary == to.vertex->primary)
        line.evenPrimary = from.vertex->primary;
    if (pass.separateSpecular)
        line.secondary = overW([](const ShadedVertex& v) { return glm::vec4(v.secondary, 0); });
    if (pass.fog) {
        const auto distance = [](const Corner& corner) {
            return double{corner.vertex->fogDistance} * corner.invW;
        };
        line.fogDistance = plane.operator()<float>(distance(from), distance(to));
    }
    for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u) {
        if (pass.units[u].texture)
            line.texCoords[u] = overW([u](const ShadedVertex& v) { return v.texCoords[u]; });
    }
}

/// Whether pixels are left within the picture.
bool cutToViewport(Triangle& triangle, Viewport viewport) {
    triangle.minX = std::max(triangle.minX, 0);
    triangle.maxX = std::min(triangle.maxX, viewport.width - 1);
    triangle.minY = std::max(triangle.minY, 0);
    triangle.maxY = std::min(triangle.maxY, viewport.height - 1);
    return triangle.minX <= triangle.maxX && triangle.minY <= triangle.maxY;
}

} // namespace

int roundedSize(float size) {
    return std::max(1, static_cast<int>(std::lround(size)));
}

std::optional<Triangle> setUpLine(const ShadedVertex& from, const ShadedVertex& to, float width,
                                  const PassState& pass, Viewport viewport, bool perspective) {
    const Corner a = cornerOf(from, viewport, perspective);
    const Corner b = cornerOf(to, viewport, perspective);
    const bool xMajor = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const auto placeOf = [xMajor](const Corner& corner) {
        return xMajor ? Place{corner.x, corner.y} : Place{corner.y, corner.x};
    };
    const Place start = placeOf(a);
    const Place end = placeOf(b);
    const bool forward = start.major <= end.major;
    const std::int64_t along = std::abs(end.major - start.major);
    const std::int64_t across = forward ? end.minor - start.minor : start.minor - end.minor;
    if (along == 0)
        return std::nullopt;

    // Section 3.4.2: the line is moved by half of what it is wider than 1, and each pixel becomes a column of
    // so many: a pixel is covered if the line passes its centre in less than half of the width.
    const std::int64_t pixels = roundedSize(width);
    const std::int64_t moved = (pixels - 1) * half;
    const auto [first, last] =
        pixelsAlong({start.major, start.minor - moved}, {end.major, end.minor - moved}, xMajor);
    if (first > last)
        return std::nullopt;
    const std::int64_t middle = start.minor * along - start.major * across;
    const std::int64_t reach = pixels * half * along;
    // Where the line runs between two pixels it is moved to the left, which lifts one that rises.
    const bool upper = xMajor && across > 0;
    const std::int64_t majorStep = across * subPixels;
    const std::int64_t minorStep = along * subPixels;
    const auto edge = [&](std::int64_t origin, std::int64_t byMajor, std::int64_t byMinor) {
        const std::int64_t dx = xMajor ? byMajor : byMinor;
        return EdgeFunction{origin, dx, xMajor ? byMinor : byMajor, 1 / std::abs(static_cast<double>(dx))};
    };
    Triangle line;
    line.edges[0] = edge(middle + reach - (upper ? 0 : 1), majorStep, -minorStep);
    line.edges[1] = edge(reach - middle - (upper ? 1 : 0), -majorStep, minorStep);
    const auto [low, high] = std::minmax(start.minor, end.minor);
    const int least = pixelAtOrBefore(low - pixels * half);
    const int most = pixelAtOrAfter(high + pixels * half);
    line.minX = xMajor ? static_cast<int>(first) : least;
    line.maxX = xMajor ? static_cast<int>(last) : most;
    line.minY = xMajor ? least : static_cast<int>(first);
    line.maxY = xMajor ? most : static_cast<int>(last);
    if (!cutToViewport(line, viewport))
        return std::nullopt;
    // From the lower end, whichever came first: the same line has the same depths once more.
    const bool up = std::pair(a.y, a.x) < std::pair(b.y, b.x);
    const Corner& bottom = up ? a : b;
    const Corner& top = up ? b : a;
    setPlanes(line, bottom, top, gradientOf(top.window - bottom.window, pixels > 1, xMajor), pass);
    return line;
}

std::optional<Triangle> setUpPoint(const ShadedVertex& vertex, float size, const PassState& pass,
                                   Viewport viewport, bool perspective) {
    const Corner corner = cornerOf(vertex, viewport, perspective);
    const int pixels = roundedSize(size);
    // Around the middle of its pixel; around the nearest corner of one, where the size is even.
    const auto firstOf = [pixels](double window) {
        const double place = pixels % 2 == 1 ? std::floor(window + 0.5) : std::floor(window + 1);
        return static_cast<int>(place) - pixels / 2;
    };
    Triangle point;
    point.minX = firstOf(corner.window.x);
    point.maxX = point.minX + pixels - 1;
    point.minY = firstOf(corner.window.y);
    point.maxY = point.minY + pixels - 1;
    if (!cutToViewport(point, viewport))
        return std::nullopt;
    setPlanes(point, corner, corner, {0, 0}, pass);
    return point;
}

} // namespace texplorer::reference
