#pragma once

// The interface of metrics: values for the pixels of a tile.

#include "texplorer/compare/criterion.h"
#include "texplorer/compare/picture_pair.h"

#include <memory>
#include <span>

namespace texplorer {

/// Reuses its working memory, so each thread needs its own.
class PixelMetric {
public:
    PixelMetric() = default;
    PixelMetric(const PixelMetric&) = delete;
    PixelMetric& operator=(const PixelMetric&) = delete;
    virtual ~PixelMetric() = default;

    /// The distance in pixels that the value of a pixel depends on. If the pictures are equal within it, the
    /// value is 0.
    [[nodiscard]] virtual int reach() const = 0;

    /// Computes the value of every pixel of the tile, from its upper left. The tile's `reach` must be this
    /// metric's.
    virtual void measure(const TilePixels& pixels, std::span<float> values) = 0;
};

/// For tiles of up to `maxTile`. `opaque`: no alpha of the pictures is below 255.
[[nodiscard]] std::unique_ptr<PixelMetric> makePixelMetric(const Criterion& criterion, bool opaque,
                                                           const Tile& maxTile);

} // namespace texplorer
