#pragma once

#include "texplorer/reference/raster/canvas.h"
#include "texplorer/reference/raster/triangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>

namespace texplorer::reference {

struct Kernel; // see raster/kernel.h

/// Whether more triangles will be drawn later; if not, depths are not stored.
enum class Remaining { None, More };

/// Draws triangles in order. Tiles of the picture are drawn by up to `threads` threads; the result does not
/// depend on their number. Ends early after a stop request. Without a kernel, pixels are drawn one by one as
/// in shade.h; the bytes are the same.
void rasterize(std::span<const Triangle> triangles, Canvas& canvas, Remaining remaining, const Kernel* kernel,
               unsigned threads, const std::stop_token& stop);

/// A range of pixels, limits included; empty if a first one is greater than its last.
struct Box {
    int left;
    int right;
    int low;
    int top;
};

/// The pixels of a box that a triangle covers, row by row.
class Coverage {
public:
    Coverage(const Triangle& triangle, Box box);

    /// Whether a current row exists, which the other functions describe. It may have no pixels.
    [[nodiscard]] bool isAtRow() const { return box_.low <= box_.top; }
    [[nodiscard]] int y() const { return box_.low; }
    [[nodiscard]] int first() const {
        std::int64_t first = box_.left;
        for (std::size_t i = 0; i < leftCount_; ++i)
            first = std::max(first, -left_[i].quotient);
        return static_cast<int>(std::min<std::int64_t>(first, box_.right + 1));
    }
    [[nodiscard]] int last() const {
        std::int64_t last = box_.right;
        for (std::size_t i = 0; i < rightCount_; ++i)
            last = std::min(last, right_[i].quotient);
        return static_cast<int>(std::max<std::int64_t>(last, box_.left - 1));
    }
    void next() {
        ++box_.low;
        for (std::size_t i = 0; i < leftCount_; ++i)
            left_[i].next();
        for (std::size_t i = 0; i < rightCount_; ++i)
            right_[i].next();
    }

private:
    /// An edge function at x = 0, divided by its change per pixel, updated from row to row by additions only.
    struct Side {
        std::int64_t quotient;
        std::int64_t rest; ///< 0 to divisor - 1
        std::int64_t quotientStep;
        std::int64_t restStep;
        std::int64_t divisor;

        void next() {
            quotient += quotientStep;
            rest += restStep;
            if (rest >= divisor) {
                rest -= divisor;
                ++quotient;
            }
        }
    };

    Box box_;
    std::array<Side, 3> left_; ///< the inside is to their right
    std::array<Side, 3> right_;
    std::size_t leftCount_ = 0;
    std::size_t rightCount_ = 0;
};

/// Calls work(first x, y, count) for every row of the box with covered pixels, upwards.
template<class Work>
void eachCoveredRow(const Triangle& triangle, Box box, const Work& work) {
    for (Coverage coverage(triangle, box); coverage.isAtRow(); coverage.next()) {
        const int first = coverage.first();
        if (const int last = coverage.last(); first <= last)
            work(first, coverage.y(), last - first + 1);
    }
}

} // namespace texplorer::reference
