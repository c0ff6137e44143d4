#include "texplorer/compare/ssim.h"

#include "texplorer/compare/plane.h"

#include <array>
#include <cmath>

namespace texplorer {

namespace {

constexpr int windowReach = 5;
constexpr double windowSigma = 1.5;
constexpr float c1 = 0.01F * 255 * (0.01F * 255);
constexpr float c2 = 0.03F * 255 * (0.03F * 255);
/// Taken off every component: what is left is small, and so is what its square loses as a float.
constexpr float middle = 128;

using Window = std::array<float, 2 * windowReach + 1>;

Window windowTaps() {
    std::array<double, std::tuple_size_v<Window>> exact{};
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double x = static_cast<double>(i) - windowReach;
        exact[i] = std::exp(-x * x / (2 * windowSigma * windowSigma));
        sum += exact[i];
    }
    Window taps{};
    for (std::size_t i = 0; i < exact.size(); ++i)
        taps[i] = static_cast<float>(exact[i] / sum);
    return taps;
}

/// What is averaged over the window: of both pictures' components, the sum of their squares, their product.
enum Average : std::size_t { ofExpected, ofActual, ofSquares, ofProduct, averageCount };

class SsimMetric : public PixelMetric {
public:
    SsimMetric(std::size_t channels, const Tile& maxTile)
        : channels_(channels)
        , pixels_(averageCount, Plane(maxTile.width + 2 * windowReach, maxTile.height + 2 * windowReach))
        , across_(averageCount, Plane(maxTile.width, maxTile.height + 2 * windowReach))
        , averages_(averageCount, Plane(maxTile.width, 1)) {}

    [[nodiscard]] int reach() const override { return windowReach; }

    void measure(const TilePixels& pixels, std::span<float> values) override {
        std::ranges::fill(values, 0.0F);
        const Tile& tile = pixels.tile;
        const auto width = static_cast<std::size_t>(tile.width);
        for (std::size_t channel = 0; channel < channels_; ++channel) {
            readChannel(pixels, channel);
            for (std::size_t i = 0; i < averageCount; ++i)
                filterAcross(pixels_[i], 0, taps_, across_[i], tile.width, pixels.height());
            for (int y = 0; y < tile.height; ++y) {
                for (std::size_t i = 0; i < averageCount; ++i)
                    filterRow(across_[i].row(y), across_[i].stride(), taps_, averages_[i].row(0), tile.width);
                addRow(values.subspan(static_cast<std::size_t>(y) * width, width));
            }
        }
    }

private:
    void readChannel(const TilePixels& pixels, std::size_t channel) {
        std::size_t i = 0;
        for (int y = 0; y < pixels.height(); ++y) {
            std::array<float*, averageCount> rows{};
            for (std::size_t each = 0; each < averageCount; ++each)
                rows[each] = pixels_[each].row(y);
            for (int x = 0; x < pixels.width(); ++x, ++i) {
                const float expected = static_cast<float>(pixels.expected[i][channel]) - middle;
                const float actual = static_cast<float>(pixels.actual[i][channel]) - middle;
                rows[ofExpected][x] = expected;
                rows[ofActual][x] = actual;
                rows[ofSquares][x] = expected * expected + actual * actual;
                rows[ofProduct][x] = expected * actual;
            }
        }
    }

    /// Equal pictures give exactly 0: both sides of the division are the same numbers then.
    void addRow(std::span<float> values) const {
        const float* const expected = averages_[ofExpected].row(0);
        const float* const actual = averages_[ofActual].row(0);
        const float* const squares = averages_[ofSquares].row(0);
        const float* const product = averages_[ofProduct].row(0);
        const float share = 1 / static_cast<float>(channels_);
        for (std::size_t x = 0; x < values.size(); ++x) {
            const float variances = squares[x] - (expected[x] * expected[x] + actual[x] * actual[x]);
            const float covariance = product[x] - expected[x] * actual[x];
            const float a = expected[x] + middle;
            const float b = actual[x] + middle;
            const float similarity =
                (2 * (a * b) + c1) * (2 * covariance + c2) / ((a * a + b * b + c1) * (variances + c2));
            values[x] += std::max(0.0F, 1 - similarity) * share;
        }
    }

    const Window taps_ = windowTaps();
    std::size_t channels_;
    std::vector<Plane> pixels_;
    std::vector<Plane> across_;
    std::vector<Plane> averages_;
};

} // namespace

std::unique_ptr<PixelMetric> makeSsim(bool opaque, const Tile& maxTile) {
    return std::make_unique<SsimMetric>(opaque ? 3 : 4, maxTile);
}

} // namespace texplorer
