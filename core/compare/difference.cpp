#include "texplorer/compare/difference.h"

#include "texplorer/compare/comparable.h"
#include "texplorer/compare/pixel_difference.h"

#include <fmt/core.h>

#include <string>

namespace texplorer {

namespace {

Sentence extentsOf(const Image& image) {
    const std::string extents = image.depth == 1
                                    ? fmt::format("{} × {}", image.width, image.height)
                                    : fmt::format("{} × {} × {}", image.width, image.height, image.depth);
    return Sentence("{0} pixels ({1})", ProperName{extents}, ProperName{rowOf(image.format).name});
}

} // namespace

Result<void> checkComparable(const Image& a, const Image& b) {
    const bool rgba = a.format == PixelFormat::Rgba8 && b.format == PixelFormat::Rgba8;
    if (rgba && a.width == b.width && a.height == b.height && a.depth == 1 && b.depth == 1)
        return {};
    return fail(rgba ? ErrorCode::OutOfRange : ErrorCode::Unsupported,
                Sentence("expected two pictures of the same size ({0}), found {1} and {2}",
                         rowOf(PixelFormat::Rgba8).name, extentsOf(a), extentsOf(b)));
}

std::size_t Difference::countOver(int tolerance) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i)
        count += static_cast<int>(i) > tolerance ? histogram[i] : 0;
    return count;
}

Result<Difference> compare(const Image& a, const Image& b, int tolerance, Compared compared) {
    if (const Result<void> comparable = checkComparable(a, b); !comparable)
        return fail(comparable.error());
    const std::size_t components = componentsOf(compared);
    Difference difference;
    difference.pixels = a.pixels.size() / 4;
    const auto* const aBytes = reinterpret_cast<const std::uint8_t*>(a.pixels.data());
    const auto* const bBytes = reinterpret_cast<const std::uint8_t*>(b.pixels.data());
    std::size_t sum = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < difference.pixels; ++i) {
        const PixelDifference here = differenceOf(aBytes + i * 4, bBytes + i * 4, components);
        sum += static_cast<std::size_t>(here.sum);
        ++difference.histogram[static_cast<std::size_t>(here.worst)];
        if (here.worst > difference.max) {
            difference.max = here.worst;
            worst = i;
        }
    }
    difference.over = difference.countOver(tolerance);
    if (difference.pixels > 0) {
        difference.mean = static_cast<double>(sum) / static_cast<double>(difference.pixels) /
                          static_cast<double>(components);
        const auto width = static_cast<std::size_t>(a.width);
        difference.worst = {static_cast<int>(worst % width), static_cast<int>(worst / width)};
    }
    return difference;
}

} // namespace texplorer
