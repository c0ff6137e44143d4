#include "texplorer/image/alpha_coverage.h"

#include "texplorer/image/linear_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace texplorer {
namespace {

using AlphaTable = std::array<std::uint8_t, 256>; ///< the new value of each alpha

// Along an axis a texel has points at -3, -1, 1 and 3 eighths of a texel from its centre. Each lies between
// the texel, of which it has this many eighths, and a neighbour: before it, before, after, after.
constexpr int points = 4;
constexpr std::array ownEighths{5, 7, 7, 5};

constexpr int neighbourOf(int at, int point, int extent) {
    return std::clamp(point < points / 2 ? at - 1 : at + 1, 0, extent - 1);
}

class Coverage {
public:
    Coverage(const Image& image, float reference)
        : width_(image.width)
        , height_(image.height)
        , rows_(image.height * image.depth)
        , limit_(static_cast<int>(std::floor(double{reference} * 255 * 64))) {
        const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
        for (auto at = static_cast<std::size_t>(alphaComponent(image.format)); at < image.pixels.size();
             at += step)
            alpha_.push_back(std::to_integer<std::uint8_t>(image.pixels[at]));
    }

    [[nodiscard]] double with(const AlphaTable& table) const {
        std::vector<int> row(static_cast<std::size_t>(width_)); // in eighths
        std::uint64_t passed = 0;
        for (int y = 0; y < rows_; ++y)
            for (int point = 0; point < points; ++point) {
                const int first = y / height_ * height_; // of the slice
                const int next = first + neighbourOf(y - first, point, height_);
                const int own = ownEighths[static_cast<std::size_t>(point)];
                for (int x = 0; x < width_; ++x)
                    row[static_cast<std::size_t>(x)] =
                        own * table[alphaAt(x, y)] + (8 - own) * table[alphaAt(x, next)];
                passed += passedOf(row);
            }
        return static_cast<double>(passed) / (static_cast<double>(alpha_.size()) * points * points);
    }

private:
    [[nodiscard]] std::uint8_t alphaAt(int x, int y) const {
        return alpha_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(x)];
    }

    [[nodiscard]] std::uint64_t passedOf(const std::vector<int>& row) const {
        std::uint64_t passed = 0;
        for (int x = 0; x < width_; ++x) {
            const int own = row[static_cast<std::size_t>(x)];
            for (int point = 0; point < points; ++point) {
                const int weight = ownEighths[static_cast<std::size_t>(point)];
                const int next = row[static_cast<std::size_t>(neighbourOf(x, point, width_))];
                passed += weight * own + (8 - weight) * next > limit_ ? 1U : 0U;
            }
        }
        return passed;
    }

    int width_;
    int height_;
    int rows_;  ///< of all slices
    int limit_; ///< in 64ths of a step of 8 bits
    std::vector<std::uint8_t> alpha_;
};

AlphaTable scaledBy(double factor) {
    AlphaTable table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<std::uint8_t>(std::lround(std::min(255.0, static_cast<double>(i) * factor)));
    return table;
}

/// The factor that brings the coverage as near as possible to `wanted`.
double factorFor(const Coverage& coverage, double wanted) {
    if (coverage.with(scaledBy(1)) == wanted)
        return 1;
    double low = 0;
    double high = 256;
    for (int halving = 0; halving < 20; ++halving) {
        const double middle = (low + high) / 2;
        (coverage.with(scaledBy(middle)) < wanted ? low : high) = middle;
    }
    const auto distance = [&](double factor) { return std::abs(coverage.with(scaledBy(factor)) - wanted); };
    return distance(high) < distance(low) ? high : low;
}

} // namespace

double alphaCoverage(const Image& image, float reference) {
    if (alphaComponent(image.format) < 0 || image.empty())
        return reference < 1 ? 1 : 0;
    return Coverage(image, reference).with(scaledBy(1));
}

Image withCoverage(Image image, float reference, double coverage) {
    const int alpha = alphaComponent(image.format);
    if (alpha < 0 || image.empty())
        return image;
    const AlphaTable table = scaledBy(factorFor(Coverage(image, reference), coverage));
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (auto at = static_cast<std::size_t>(alpha); at < image.pixels.size(); at += step)
        image.pixels[at] = std::byte{table[std::to_integer<std::size_t>(image.pixels[at])]};
    return image;
}

} // namespace texplorer
