#pragma once

// What each metric makes of a piece of the pictures.

#include "core/compare/criterion.h"
#include "core/compare/picture_pair.h"

#include <memory>
#include <span>

namespace texplorer {

/// Has memory to work in, which it uses again: each thread has one of its own.
class PixelMetric {
public:
    PixelMetric() = default;
    PixelMetric(const PixelMetric&) = delete;
    PixelMetric& operator=(const PixelMetric&) = delete;
    virtual ~PixelMetric() = default;

    /// How many pixels around a pixel its value depends on. Where two pictures are equal within that, it is
    /// 0.
    [[nodiscard]] virtual int reach() const = 0;

    /// The value of every pixel of the tile, whose `reach` is this one's, from its upper left.
    virtual void measure(const TilePixels& pixels, std::span<float> values) = 0;
};

/// For tiles of up to `largest`. `opaque`: no alpha of the pictures is below 255.
[[nodiscard]] std::unique_ptr<PixelMetric> makePixelMetric(const Criterion& criterion, bool opaque,
                                                           const Tile& largest);

} // namespace texplorer
