#include "core/reference/raster.h"

#include "core/base/parallel.h"
#include "core/reference/fast_shade.h"
#include "core/reference/fragment.h"
#include "core/reference/shade.h"
#include "core/reference/stored_color.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace texplorer::reference {

namespace {

constexpr int tileExtent = rowCapacity;

std::int64_t floorDivided(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

void drawFragment(const Triangle& triangle, int x, int y, Canvas& canvas) {
    const Pass& pass = *triangle.pass->pass;
    const glm::vec2 offset = glm::vec2(x, y) - triangle.origin;
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.color.width) +
                    static_cast<std::size_t>(x);
    std::uint32_t depth = 0;
    if (pass.depthTest) {
        // Before texturing, because it is cheaper; what fails either test is lost in any order.
        depth = fragmentDepth(triangle, offset);
        if (!passes(pass.depthFunc, depth, canvas.depth[at]))
            return;
    }
    glm::vec4 color = fragmentColor(triangle, offset);
    if (pass.alphaTest && !passes(pass.alphaFunc, color.a, std::clamp(pass.alphaRef, 0.0F, 1.0F)))
        return;
    if (pass.depthTest) // section 4.1.6: without the test nothing is written
        canvas.depth[at] = depth;
    std::byte* pixel = canvas.color.pixels.data() + 4 * at;
    if (pass.blend)
        color = blend(pass.blendSrc, pass.blendDst, color, colorOf(pixel));
    store(color, pixel);
}

} // namespace

Canvas::Canvas(Viewport viewport, glm::vec4 background)
    : color(Image::uninitialised(PixelFormat::Rgba8, viewport.width, viewport.height))
    , depth(static_cast<std::size_t>(viewport.width) * static_cast<std::size_t>(viewport.height),
            farthestDepth) {
    std::array<std::byte, 4> cleared{};
    store(background, cleared.data());
    for (std::size_t i = 0; i < color.pixels.size(); i += 4)
        std::memcpy(color.pixels.data() + i, cleared.data(), 4);
}

Span coveredPixels(const Triangle& triangle, int y, Span within) {
    // Every edge function grows or falls along the row: it leaves the pixels on one side.
    std::int64_t first = std::max(within.first, triangle.minX);
    std::int64_t last = std::min(within.last, triangle.maxX);
    for (const EdgeFunction& edge : triangle.edges) {
        const std::int64_t value = edge.origin + edge.dy * y;
        if (edge.dx > 0)
            first = std::max(first, -floorDivided(value, edge.dx));
        else if (edge.dx < 0)
            last = std::min(last, floorDivided(value, -edge.dx));
        else if (value < 0)
            return {0, -1};
    }
    if (first > last) // perhaps by more than an int holds
        return {0, -1};
    return {static_cast<int>(first), static_cast<int>(last)};
}

void rasterize(std::span<const Triangle> triangles, Canvas& canvas, unsigned threads, std::stop_token stop,
               bool literal) {
    const auto [width, height] = canvas.viewport();
    const int columns = (width + tileExtent - 1) / tileExtent;
    const int rows = (height + tileExtent - 1) / tileExtent;
    std::vector<std::vector<std::uint32_t>> tiles(static_cast<std::size_t>(columns) *
                                                  static_cast<std::size_t>(rows));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& triangle = triangles[i];
        for (int row = triangle.minY / tileExtent; row <= triangle.maxY / tileExtent; ++row) {
            for (int column = triangle.minX / tileExtent; column <= triangle.maxX / tileExtent; ++column)
                tiles[static_cast<std::size_t>(row * columns + column)].push_back(
                    static_cast<std::uint32_t>(i));
        }
    }
    parallelFor(tiles.size(), threads, [&](std::size_t tile) {
        const int left = static_cast<int>(tile) % columns * tileExtent;
        const int low = static_cast<int>(tile) / columns * tileExtent;
        for (const std::uint32_t i : tiles[tile]) {
            if (stop.stop_requested())
                return;
            const Triangle& triangle = triangles[i];
            const int top = std::min(triangle.maxY, low + tileExtent - 1);
            for (int y = std::max(triangle.minY, low); y <= top; ++y) {
                const Span span = coveredPixels(triangle, y, {left, left + tileExtent - 1});
                if (!literal && span.first <= span.last)
                    drawRow(triangle, span.first, y, span.last - span.first + 1, canvas);
                for (int x = span.first; literal && x <= span.last; ++x)
                    drawFragment(triangle, x, y, canvas);
            }
        }
    });
}

} // namespace texplorer::reference
