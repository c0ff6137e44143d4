#include "core/reference/raster.h"

#include "core/base/parallel.h"
#include "core/reference/fast_shade.h"
#include "core/reference/fragment.h"
#include "core/reference/lanes.h"
#include "core/reference/shade.h"
#include "core/reference/stored_color.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace texplorer::reference {

namespace {

constexpr int tileExtent = rowCapacity;

/// value / divisor rounded down, for a positive divisor; `inverse` is 1 / divisor. Much faster than to
/// divide.
std::int64_t floorDivided(std::int64_t value, std::int64_t divisor, double inverse) {
    auto quotient = static_cast<std::int64_t>(static_cast<double>(value) * inverse);
    while (quotient * divisor > value)
        --quotient;
    while ((quotient + 1) * divisor <= value)
        ++quotient;
    return quotient;
}

void drawFragment(const Triangle& triangle, int x, int y, Canvas& canvas) {
    const Pass& pass = *triangle.pass->pass;
    const glm::vec2 offset = glm::vec2(x, y) - triangle.origin;
    const std::size_t at = canvas.pixelAt(x, y);
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

/// A square of the picture.
class Tile {
public:
    Tile(std::span<const Triangle> triangles, Canvas& canvas, int left, int low)
        : triangles_(triangles)
        , canvas_(canvas)
        , left_(left)
        , right_(std::min(left + tileExtent, canvas.color.width) - 1)
        , low_(low)
        , top_(std::min(low + tileExtent, canvas.color.height) - 1) {}

    /// Those of the triangles that have these numbers, in this order.
    void draw(const std::vector<std::uint32_t>& numbers, const std::stop_token& stop, bool literal) {
        if (!canvas_.cleared)
            clear();
        for (const std::uint32_t number : numbers) {
            if (stop.stop_requested())
                return;
            const Triangle& triangle = triangles_[number];
            const Pass& pass = *triangle.pass->pass;
            if (literal) {
                eachRow(triangle, [&](int x, int y, int count) {
                    for (int end = x + count; x < end; ++x)
                        drawFragment(triangle, x, y, canvas_);
                });
            } else if (pass.blend || pass.alphaTest) {
                shadeMarked(); // it may look through to what is there by now
                eachRow(triangle, [&](int x, int y, int count) { drawRow(triangle, x, y, count, canvas_); });
            } else {
                if (!marked_)
                    owners_.fill(nobody);
                marked_ = true;
                eachRow(triangle, [&](int x, int y, int count) {
                    markRow(triangle, number, x, y, count, canvas_, owners(x, y));
                });
            }
        }
        shadeMarked();
    }

private:
    static constexpr std::uint32_t nobody = ~0U;

    template<class Work>
    void eachRow(const Triangle& triangle, const Work& work) {
        const int top = std::min(triangle.maxY, top_);
        for (int y = std::max(triangle.minY, low_); y <= top; ++y) {
            const Span span = coveredPixels(triangle, y, {left_, right_});
            if (span.first <= span.last)
                work(span.first, y, span.last - span.first + 1);
        }
    }

    std::uint32_t* owners(int x, int y) { return owners_.data() + (y - low_) * tileExtent + (x - left_); }

    void clear() {
        std::array<std::byte, std::size_t{4} * tileExtent> row;
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = canvas_.background[i % 4];
        const auto count = static_cast<std::size_t>(right_ - left_ + 1);
        for (int y = low_; y <= top_; ++y) {
            const std::size_t at = canvas_.pixelAt(left_, y);
            std::fill_n(canvas_.depth.data() + at, count, farthestDepth);
            std::memcpy(canvas_.color.pixels.data() + 4 * at, row.data(), 4 * count);
        }
    }

    void shadeMarked() {
        if (!marked_)
            return;
        marked_ = false;
        for (int y = low_; y <= top_; ++y) {
            for (int x = left_; x <= right_;) {
                const std::uint32_t* owner = owners(x, y);
                int end = x + 1;
                const Ints same = ints(static_cast<int>(*owner));
                while (end + laneCount - 1 <= right_ && all(loadAs<Ints>(owner + (end - x)) == same))
                    end += laneCount;
                while (end <= right_ && owner[end - x] == *owner)
                    ++end;
                if (*owner != nobody)
                    shadeRow(triangles_[*owner], x, y, end - x, canvas_);
                x = end;
            }
        }
    }

    std::span<const Triangle> triangles_;
    Canvas& canvas_;
    int left_;
    int right_;
    int low_;
    int top_;
    bool marked_ = false;
    std::array<std::uint32_t, std::size_t{tileExtent} * tileExtent> owners_;
};

} // namespace

Canvas::Canvas(Viewport viewport, glm::vec4 clearColor, std::vector<std::uint32_t> memory)
    : color(Image::uninitialised(PixelFormat::Rgba8, viewport.width, viewport.height))
    , depth(std::move(memory)) {
    depth.resize(static_cast<std::size_t>(viewport.width) * static_cast<std::size_t>(viewport.height));
    store(clearColor, background.data());
}

Span coveredPixels(const Triangle& triangle, int y, Span within) {
    // Every edge function grows or falls along the row: it leaves the pixels on one side.
    std::int64_t first = std::max(within.first, triangle.minX);
    std::int64_t last = std::min(within.last, triangle.maxX);
    for (const EdgeFunction& edge : triangle.edges) {
        const std::int64_t value = edge.origin + edge.dy * y;
        if (edge.dx > 0)
            first = std::max(first, -floorDivided(value, edge.dx, edge.inverse));
        else if (edge.dx < 0)
            last = std::min(last, floorDivided(value, -edge.dx, edge.inverse));
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
        Tile(triangles, canvas, static_cast<int>(tile) % columns * tileExtent,
             static_cast<int>(tile) / columns * tileExtent)
            .draw(tiles[tile], stop, literal);
    });
    canvas.cleared = true;
}

} // namespace texplorer::reference
