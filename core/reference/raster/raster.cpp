#include "texplorer/reference/raster/raster.h"

#include "texplorer/base/parallel.h"
#include "texplorer/reference/raster/kernel.h"
#include "texplorer/reference/raster/shade.h"
#include "texplorer/reference/shading/fragment.h"
#include "texplorer/reference/shading/stored_color.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace texplorer::reference {

namespace {

constexpr int tileExtent = rowCapacity;

struct Division {
    std::int64_t quotient; ///< rounded down
    std::int64_t rest;
};

/// `inverse` is 1 / divisor, which is positive. Much faster than to divide.
Division divided(std::int64_t value, std::int64_t divisor, double inverse) {
    const auto quotient = static_cast<std::int64_t>(static_cast<double>(value) * inverse);
    const std::int64_t rest = value - quotient * divisor; // one off at most
    if (rest < 0)
        return {quotient - 1, rest + divisor};
    if (rest >= divisor)
        return {quotient + 1, rest - divisor};
    return {quotient, rest};
}

void drawFragment(const Triangle& triangle, int x, int y, std::uint32_t& storedDepth, std::byte* pixel) {
    const Pass& pass = *triangle.pass->pass;
    const glm::vec2 offset = glm::vec2(x, y) - triangle.origin;
    std::uint32_t depth = 0;
    if (pass.depthTest) {
        // Before texturing, because it is cheaper; what fails either test is lost in any order.
        depth = fragmentDepth(triangle, offset);
        if (!passes(pass.depthFunc, depth, storedDepth))
            return;
    }
    glm::vec4 color = fragmentColor(triangle, offset);
    if (pass.alphaTest && !passes(pass.alphaFunc, color.a, std::clamp(pass.alphaRef, 0.0F, 1.0F)))
        return;
    if (pass.depthTest) // section 4.1.6: without the test nothing is written
        storedDepth = depth;
    if (pass.blend)
        color = blend(pass.blendSrc, pass.blendDst, color, colorOf(pixel));
    store(color, pixel);
}

/// A square of the picture. It is drawn in memory of its own, where one may write beyond the end of a row.
class Tile {
public:
    Tile(std::span<const Triangle> triangles, const Kernel* kernel, Canvas& canvas, int left, int low)
        : triangles_(triangles)
        , kernel_(kernel)
        , canvas_(canvas)
        , box_{left, std::min(left + tileExtent, canvas.color.width) - 1, low,
               std::min(low + tileExtent, canvas.color.height) - 1} {}

    /// Those of the triangles that have these numbers, in this order.
    void draw(const std::vector<std::uint32_t>& numbers, const std::stop_token& stop) {
        if (canvas_.cleared)
            load();
        else
            clear();
        for (const std::uint32_t number : numbers) {
            if (stop.stop_requested())
                break;
            const Triangle& triangle = triangles_[number];
            const Pass& pass = *triangle.pass->pass;
            if (!kernel_) {
                eachRow(triangle, [&](const PixelRow& row) {
                    for (int i = 0; i < row.count; ++i)
                        drawFragment(triangle, row.x + i, row.y, row.depth[i],
                                     row.colors + std::ptrdiff_t{4} * i);
                });
            } else if (numbers.size() == 1 || pass.blend || pass.alphaTest) {
                shadeMarked(); // it may look through to what is there by now
                eachRow(triangle, [&](const PixelRow& row) { kernel_->draw(triangle, row); });
            } else {
                if (!marked_)
                    owners_.fill(noTriangle);
                marked_ = true;
                eachRow(triangle, [&](const PixelRow& row) {
                    kernel_->mark(triangle, number, row, owners_.data() + indexOf(row.x, row.y));
                });
            }
        }
        shadeMarked();
        store();
    }

private:
    static constexpr std::size_t room = std::size_t{tileExtent} * tileExtent + rowSlack;

    template<class Work>
    void eachRow(const Triangle& triangle, const Work& work) {
        eachCoveredRow(triangle, box_, [&](int x, int y, int count) { work(rowAt(x, y, count)); });
    }

    [[nodiscard]] std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(y - box_.low) * tileExtent + static_cast<std::size_t>(x - box_.left);
    }
    [[nodiscard]] PixelRow rowAt(int x, int y, int count) {
        return {x, y, count, depth_.data() + indexOf(x, y),
                reinterpret_cast<std::byte*>(colors_.data() + indexOf(x, y))};
    }

    void clear() {
        colors_.fill(canvas_.background);
        depth_.fill(farthestDepth);
    }

    void load() {
        eachRow([&](std::size_t own, std::size_t kept, std::size_t count) {
            std::memcpy(colors_.data() + own, canvas_.color.pixels.data() + 4 * kept, 4 * count);
            std::copy_n(canvas_.depth.data() + kept, count, depth_.data() + own);
        });
    }

    void store() {
        eachRow([&](std::size_t own, std::size_t kept, std::size_t count) {
            std::memcpy(canvas_.color.pixels.data() + 4 * kept, colors_.data() + own, 4 * count);
            if (!canvas_.depth.empty())
                std::copy_n(depth_.data() + own, count, canvas_.depth.data() + kept);
        });
    }

    /// Calls work with a row's index here and in the canvas, and its length.
    template<class Work>
    void eachRow(const Work& work) {
        for (int y = box_.low; y <= box_.top; ++y)
            work(indexOf(box_.left, y), canvas_.pixelAt(box_.left, y),
                 static_cast<std::size_t>(box_.right - box_.left + 1));
    }

    void shadeMarked() {
        if (!marked_)
            return;
        marked_ = false;
        for (int y = box_.low; y <= box_.top; ++y)
            kernel_->shade(triangles_, owners_.data() + indexOf(box_.left, y),
                           rowAt(box_.left, y, box_.right - box_.left + 1));
    }

    std::span<const Triangle> triangles_;
    const Kernel* kernel_;
    Canvas& canvas_;
    Box box_;
    bool marked_ = false;
    std::array<std::uint32_t, room> depth_;
    std::array<std::uint32_t, room> colors_;
    std::array<std::uint32_t, room> owners_;
};

/// Whether one edge leaves all of the box outside.
bool isOutside(const Triangle& triangle, Box box) {
    return std::ranges::any_of(triangle.edges, [&](const EdgeFunction& edge) {
        return edge.origin + edge.dx * (edge.dx > 0 ? box.right : box.left) +
                   edge.dy * (edge.dy > 0 ? box.top : box.low) <
               0;
    });
}

} // namespace

Canvas::Canvas(Viewport viewport, glm::vec4 clearColor)
    : color(Image::uninitialised(PixelFormat::Rgba8, viewport.width, viewport.height)) {
    store(clearColor, reinterpret_cast<std::byte*>(&background));
}

Coverage::Coverage(const Triangle& triangle, Box box)
    : box_{std::max(box.left, triangle.minX), std::min(box.right, triangle.maxX),
           std::max(box.low, triangle.minY), std::min(box.top, triangle.maxY)} {
    if (box_.left > box_.right)
        box_.top = box_.low - 1;
    for (const EdgeFunction& edge : triangle.edges) {
        if (edge.dx != 0)
            continue;
        // A horizontal edge leaves whole rows outside.
        while (isAtRow() && edge.origin + edge.dy * box_.low < 0)
            ++box_.low;
        while (isAtRow() && edge.origin + edge.dy * box_.top < 0)
            --box_.top;
    }
    for (const EdgeFunction& edge : triangle.edges) {
        const std::int64_t leastInside = edge.origin + edge.dx * (edge.dx > 0 ? box_.left : box_.right) +
                                         edge.dy * (edge.dy > 0 ? box_.low : box_.top);
        if (edge.dx == 0 || leastInside >= 0)
            continue;
        const std::int64_t divisor = std::abs(edge.dx);
        const Division at = divided(edge.origin + edge.dy * box_.low, divisor, edge.inverse);
        const Division step = divided(edge.dy, divisor, edge.inverse);
        (edge.dx > 0 ? left_[leftCount_++] : right_[rightCount_++]) = {at.quotient, at.rest, step.quotient,
                                                                       step.rest, divisor};
    }
}

void rasterize(std::span<const Triangle> triangles, Canvas& canvas, Remaining remaining, const Kernel* kernel,
               unsigned threads, const std::stop_token& stop) {
    const int width = canvas.color.width;
    const int height = canvas.color.height;
    if (remaining == Remaining::More && canvas.depth.empty())
        canvas.depth.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const int columns = (width + tileExtent - 1) / tileExtent;
    const int rows = (height + tileExtent - 1) / tileExtent;
    std::vector<std::vector<std::uint32_t>> tiles(static_cast<std::size_t>(columns) *
                                                  static_cast<std::size_t>(rows));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& triangle = triangles[i];
        const int left = triangle.minX / tileExtent;
        const int right = triangle.maxX / tileExtent;
        const int low = triangle.minY / tileExtent;
        const int top = triangle.maxY / tileExtent;
        const bool isSmall = left == right || low == top;
        for (int row = low; row <= top; ++row) {
            for (int column = left; column <= right; ++column) {
                const Box box{column * tileExtent, (column + 1) * tileExtent - 1, row * tileExtent,
                              (row + 1) * tileExtent - 1};
                if (isSmall || !isOutside(triangle, box))
                    tiles[static_cast<std::size_t>(row * columns + column)].push_back(
                        static_cast<std::uint32_t>(i));
            }
        }
    }
    parallelFor(tiles.size(), threads, [&](std::size_t tile) {
        Tile(triangles, kernel, canvas, static_cast<int>(tile) % columns * tileExtent,
             static_cast<int>(tile) / columns * tileExtent)
            .draw(tiles[tile], stop);
    });
    canvas.cleared = true;
}

} // namespace texplorer::reference
