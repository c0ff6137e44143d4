#pragma once

// Whether a picture is the one that was expected: what differs, where, and by how much.

#include "core/base/result.h"
#include "core/compare/criterion.h"
#include "core/compare/difference.h"
#include "core/compare/heat_map.h"
#include "core/image/image.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace texplorer {

/// Columns and rows of a picture, counted from its upper left.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const PixelRect&) const = default;
};

/// Pixels above the tolerance that touch each other, at a side or at a corner.
struct DifferentRegion {
    PixelRect bounds;
    std::size_t pixels = 0;

    bool operator==(const DifferentRegion&) const = default;
};

/// One pixel of both pictures.
struct ComparedPixel {
    glm::ivec2 at{0}; ///< from the upper left
    std::array<std::uint8_t, 4> expected{};
    std::array<std::uint8_t, 4> actual{};
    double value = 0; ///< of the metric

    bool operator==(const ComparedPixel&) const = default;
};

/// Positions are counted from the upper left, unlike an Image's own rows, because people read them; but that
/// of `difference`.
struct Comparison {
    Criterion criterion;
    bool alike = false;
    glm::ivec2 expectedSize{0};
    glm::ivec2 actualSize{0}; ///< where it isn't the expected one, everything below but `sentence` is empty
    std::size_t pixels = 0;   ///< that count: all, or those that the mask leaves
    std::size_t over = 0;     ///< of these, with a value above the tolerance
    double score = 0;         ///< a mean over what counts: difference.mean, SSIM (1: equal), the FLIP error
    ComparedPixel worst; ///< the one with the largest value, the first of them from the upper left; no pixel
                         ///< if that is 0
    PixelRect bounds;    ///< of the pixels above the tolerance
    std::size_t regions = 0;
    std::vector<DifferentRegion> largest; ///< the regions with the most pixels, these first; at most 8
    /// In 255ths, whatever the metric is, of the pixels that count. `over` is what exceeds the tolerance of
    /// Absolute, or 0 of another metric. Its `worst` has row 0 at the bottom.
    Difference difference;
    std::string
        sentence; ///< "12 of 65536 pixels (0.018 %) differ by more than 2/255, …", without a file's name
    /// Every pixel's value as a colour of heat_map.h's scale: Rgba8, opaque, black where nothing differs and
    /// grey where the mask is. Empty unless ComparisonWork::map.
    Image map;

    [[nodiscard]] bool sameSize() const { return expectedSize == actualSize; }
    /// Of the pixels that count, 0 to 1; 0 where there is none.
    [[nodiscard]] double shareOver() const {
        return pixels == 0 ? 0 : static_cast<double>(over) / static_cast<double>(pixels);
    }
};

/// How it is done.
struct ComparisonWork {
    bool map = true;      ///< makes Comparison::map, which is as large as each of the pictures
    unsigned threads = 0; ///< 0: as many as there are processors
    std::stop_token stop{};
    std::function<void(float)> report{}; ///< how far it is, 0 to 1; from any of the threads
};

/// Pictures of any format of files (core/image/convert.h: as OpenGL sees them), of one slice. Two sizes are
/// no error, they are not alike. A pixel of the mask that is black or wholly transparent doesn't count, and
/// what lies there changes nothing around it. The same pictures give the same numbers whatever the threads.
/// Errors: what checkCriterion says; Unsupported for a volume or depths; OutOfRange for a mask of another
/// size or one that leaves nothing; TooLarge without memory (comparisonBytes); Cancelled.
[[nodiscard]] Result<Comparison> comparePictures(const Image& expected, const Image& actual,
                                                 const Criterion& criterion = {}, const Image* mask = nullptr,
                                                 const ComparisonWork& work = {});

/// What the colours of Comparison::map mean: 255ths of Absolute's differences, and 1 of another metric's
/// values as 255.
[[nodiscard]] HeatScale mapScale(Metric metric, double tolerance);

/// How much memory it takes at most, beside the pictures themselves.
[[nodiscard]] std::uint64_t comparisonBytes(glm::ivec2 size, const Criterion& criterion,
                                            const ComparisonWork& work = {});

} // namespace texplorer
