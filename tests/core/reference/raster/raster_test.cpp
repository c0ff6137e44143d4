// Which pixels a triangle covers, against its three edge functions, asked at every pixel.

#include "texplorer/reference/raster/kernel.h"
#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/shading/pass_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace texplorer::reference::raster_test {
namespace {

constexpr Viewport viewport{97, 71};

bool covers(const Triangle& triangle, int x, int y) {
    return x >= triangle.minX && x <= triangle.maxX && y >= triangle.minY && y <= triangle.maxY &&
           std::ranges::all_of(triangle.edges, [&](const EdgeFunction& edge) {
               return edge.origin + edge.dx * x + edge.dy * y >= 0;
           });
}

/// Triangles of every size; a corner in four lies on a pixel's centre, so that edges are level or upright.
class Triangles {
public:
    Triangles() { state_.pass = &pass_; }

    std::optional<Triangle> next() {
        std::array<ShadedVertex, 3> corners;
        const float extent = std::exp2(static_cast<float>(random_() % 9)) / 32;
        const glm::vec2 middle(number() * 1.2F, number() * 1.2F);
        for (ShadedVertex& corner : corners) {
            glm::vec2 at = middle + extent * glm::vec2(number(), number());
            if (random_() % 4 == 0)
                at = {centre(at.x, viewport.width), centre(at.y, viewport.height)};
            corner.clip = {at, 0, 1};
        }
        return setUp(corners[0], corners[1], corners[2], state_, viewport, true);
    }

    /// One with depths, its corners in each of their six orders.
    std::vector<Triangle> inEveryOrder() {
        std::array<ShadedVertex, 3> corners;
        for (ShadedVertex& corner : corners)
            corner.clip = glm::vec4(number(), number(), number(), 1) * (1.5F + number());
        std::array order{0U, 1U, 2U};
        std::vector<Triangle> triangles;
        do {
            if (auto made =
                    setUp(corners[order[0]], corners[order[1]], corners[order[2]], state_, viewport, true))
                triangles.push_back(*made);
        } while (std::ranges::next_permutation(order).found);
        return triangles;
    }

    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

private:
    float number() { return static_cast<float>(random_() & 0xFFFFFF) / 0x1p23F - 1; }
    static float centre(float at, int extent) {
        const auto pixels = static_cast<float>(extent);
        return (std::floor((at + 1) / 2 * pixels) + 0.5F) / pixels * 2 - 1;
    }

    std::mt19937 random_{2};
    Pass pass_;
    PassState state_;
};

TEST(CoveredRows, AreWhereTheEdgeFunctionsSaySo) {
    Triangles triangles;
    int covered = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::optional<Triangle> triangle = triangles.next();
        if (!triangle)
            continue;
        const int left = triangles.below(viewport.width);
        const int low = triangles.below(viewport.height);
        const Box box{left, std::min(left + triangles.below(60), viewport.width - 1), low,
                      std::min(low + triangles.below(60), viewport.height - 1)};
        std::vector<int> found(std::size_t{viewport.width} * viewport.height);
        eachCoveredRow(*triangle, box, [&](int x, int y, int count) {
            ASSERT_TRUE(x >= box.left && y >= box.low && y <= box.top && count > 0);
            ASSERT_LE(x + count - 1, box.right);
            for (const int end = x + count; x < end; ++x)
                ++found[static_cast<std::size_t>(y * viewport.width + x)];
        });
        for (int y = box.low; y <= box.top; ++y) {
            for (int x = box.left; x <= box.right; ++x) {
                const int expected = covers(*triangle, x, y) ? 1 : 0;
                ASSERT_EQ(found[static_cast<std::size_t>(y * viewport.width + x)], expected)
                    << "triangle " << i << " at " << x << ", " << y;
                covered += expected;
            }
        }
    }
    EXPECT_GT(covered, 100'000);
}

TEST(CoveredRows, OfABoxBesideTheTriangleAreNone) {
    Triangles triangles;
    for (int i = 0; i < 200; ++i) {
        const std::optional<Triangle> triangle = triangles.next();
        if (!triangle)
            continue;
        for (const Box box : {Box{triangle->maxX + 1, triangle->maxX + 5, 0, viewport.height - 1},
                              Box{triangle->minX - 5, triangle->minX - 1, 0, viewport.height - 1},
                              Box{0, viewport.width - 1, triangle->maxY + 1, triangle->maxY + 5},
                              Box{0, viewport.width - 1, triangle->minY - 5, triangle->minY - 1}})
            eachCoveredRow(*triangle, box, [&](int x, int y, int) { ADD_FAILURE() << x << ", " << y; });
    }
}

// Through tiles and their lists of triangles: every covered pixel is drawn, and no other.
TEST(Rasterize, DrawsWhatTheEdgeFunctionsSay) {
    std::vector<const Kernel*> ways(kernels().begin(), kernels().end());
    ways.push_back(nullptr);
    for (const Kernel* kernel : ways) {
        SCOPED_TRACE(kernel ? kernel->lanes : 0);
        Triangles triangles;
        for (int i = 0; i < 300; ++i) {
            const std::optional<Triangle> triangle = triangles.next();
            if (!triangle)
                continue;
            Canvas canvas(viewport, glm::vec4(0));
            rasterize(std::span(&*triangle, 1), canvas, Remaining::None, kernel, 2, {});
            for (int y = 0; y < viewport.height; ++y) {
                for (int x = 0; x < viewport.width; ++x)
                    ASSERT_EQ(canvas.color.pixels[4 * canvas.pixelAt(x, y)] != std::byte{0},
                              covers(*triangle, x, y))
                        << "triangle " << i << " at " << x << ", " << y;
            }
        }
    }
}

// Drawn again from another corner on, or from behind, a triangle has the same depth at every pixel: GL_LEQUAL
// lets it pass.
TEST(Triangle, HasTheSameDepthsWhicheverCornerComesFirst) {
    Triangles triangles;
    for (int i = 0; i < 200; ++i) {
        const std::vector<Triangle> made = triangles.inEveryOrder();
        for (const Triangle& each : made) {
            EXPECT_EQ(each.origin, made[0].origin);
            EXPECT_EQ(each.depth.origin, made[0].depth.origin);
            EXPECT_EQ(each.depth.dx, made[0].depth.dx);
            EXPECT_EQ(each.depth.dy, made[0].depth.dy);
        }
    }
}

} // namespace
} // namespace texplorer::reference::raster_test
