#pragma once

// Compares a picture with the expected one: what differs, where, and by how much.

#include "texplorer/base/result.h"
#include "texplorer/compare/criterion.h"
#include "texplorer/compare/difference.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/image/image.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace texplorer {

/// A rectangle of pixels, from the upper left.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const PixelRect&) const = default;
};

/// Connected pixels above the tolerance (sides or corners touch).
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

/// Positions are counted from the upper left, as users expect, not as in Image; except those of `difference`.
struct Comparison {
    Criterion criterion;
    bool alike = false;
    glm::ivec2 expectedSize{0};
    glm::ivec2 actualSize{0}; ///< if it is not the expected size, everything below except `sentence` is empty
    std::size_t pixels = 0;   ///< compared pixels: all, or those that the mask leaves
    std::size_t over = 0;     ///< of these, with a value above the tolerance
    /// The mean over the compared pixels: difference.mean, SSIM (1: equal), or the FLIP error.
    double score = 0;
    ComparedPixel
        worst;        ///< the pixel with the largest value, the first from the upper left; none if that is 0
    PixelRect bounds; ///< of the pixels above the tolerance
    std::size_t regions = 0;
    std::vector<DifferentRegion> largest; ///< the regions with the most pixels, sorted; at most 8
    /// In units of 1/255, regardless of the metric, over the compared pixels. `over` counts pixels above the
    /// tolerance of Absolute; with another metric, above 0. In `worst`, row 0 is the bottom.
    Difference difference;
    Sentence sentence; ///< "12 of 65536 pixels (0.018 %) differ by more than 2/255, …", without a file name
    /// Every pixel's value as a colour of heat_map.h's scale: Rgba8, opaque; black where nothing differs,
    /// grey in the mask. Empty unless ComparisonWork::map.
    Image map;

    [[nodiscard]] bool sameSize() const { return expectedSize == actualSize; }
    /// The share of compared pixels, 0 to 1; 0 if there are none.
    [[nodiscard]] double shareOver() const {
        return pixels == 0 ? 0 : static_cast<double>(over) / static_cast<double>(pixels);
    }
};

/// Options of the computation.
struct ComparisonWork {
    bool map = true;      ///< makes Comparison::map, which is as large as a picture
    unsigned threads = 0; ///< 0: one per processor
    std::stop_token stop{};
    std::function<void(float)> report{}; ///< progress, 0 to 1; called on any of the threads
};

/// Compares pictures of any format of image files, of one slice (converted as OpenGL sees them,
/// texplorer/image/convert.h). Pictures of two sizes are not an error, but not alike. Pixels where the mask
/// is black or fully transparent are not compared and do not affect their neighbours. The result does not
/// depend on the number of threads. Errors: those of checkCriterion; Unsupported for volumes and depths;
/// OutOfRange for a mask of another size or one that leaves no pixels; TooLarge without memory
/// (comparisonBytes); Cancelled.
[[nodiscard]] Result<Comparison> comparePictures(const Image& expected, const Image& actual,
                                                 const Criterion& criterion = {}, const Image* mask = nullptr,
                                                 const ComparisonWork& work = {});

/// The scale of Comparison::map: units of 1/255 for Absolute; for other metrics, 255 is a value of 1.
[[nodiscard]] HeatScale mapScale(Metric metric, double tolerance);

/// The maximum memory that a comparison needs, without the pictures themselves.
[[nodiscard]] std::uint64_t comparisonBytes(glm::ivec2 size, const Criterion& criterion,
                                            const ComparisonWork& work = {});

} // namespace texplorer
