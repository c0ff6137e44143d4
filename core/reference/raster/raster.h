#pragma once

#include "core/reference/raster/canvas.h"
#include "core/reference/raster/triangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>

namespace texplorer::reference {

struct Kernel; // see raster/kernel.h

/// Whether more triangles will be drawn: if none, the depths of the picture are not kept.
enum class Remaining { None, More };

/// Draws triangles in their order. Tiles of the picture are drawn by up to `threads` threads; the result is
/// the same with any number. Stops early when it is asked to. Without a kernel: pixel by pixel, as shade.h
/// has it; the bytes are the same, only later.
void rasterize(std::span<const Triangle> triangles, Canvas& canvas, Remaining remaining, const Kernel* kernel,
               unsigned threads, const std::stop_token& stop);

/// Pixels of the picture, the limits included; none where one of the first is greater than its last.
struct Box {
    int left;
    int right;
    int low;
    int top;
};

/// What a triangle covers of a box, row by row.
class Coverage {
public:
    Coverage(const Triangle& triangle, Box box);

    /// Whether there is a row left, which the others then describe. It may be one without pixels.
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
    /// An edge function at x = 0, divided by how it changes along the row: from row to row by additions
    /// alone.
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
    std::array<Side, 3> left_; ///< inside is to the right of them
    std::array<Side, 3> right_;
    std::size_t leftCount_ = 0;
    std::size_t rightCount_ = 0;
};

/// Calls work(first x, y, count) for every row of the box in which the triangle covers pixels, upwards.
template<class Work>
void eachCoveredRow(const Triangle& triangle, Box box, const Work& work) {
    for (Coverage coverage(triangle, box); coverage.isAtRow(); coverage.next()) {
        const int first = coverage.first();
        if (const int last = coverage.last(); first <= last)
            work(first, coverage.y(), last - first + 1);
    }
}

} // namespace texplorer::reference
