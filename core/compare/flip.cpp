#include "texplorer/compare/flip.h"

#include "texplorer/compare/flip_color.h"
#include "texplorer/compare/flip_filters.h"
#include "texplorer/compare/plane.h"
#include "texplorer/image/linear_light.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace texplorer {

namespace {

constexpr float colorExponent = 0.7F;    // qc
constexpr float colorSplit = 0.4F;       // pc: of the largest difference,
constexpr float colorSplitValue = 0.95F; // pt: what that becomes
constexpr float featureExponent = 0.5F;  // qf

/// What a picture looks like, pixel by pixel of a tile.
struct Appearance {
    explicit Appearance(const Tile& maxTile)
        : color(3, Plane(maxTile.width, maxTile.height))
        , edges(maxTile.width, maxTile.height)
        , points(maxTile.width, maxTile.height) {}

    std::vector<Plane> color; ///< huntLabOf
    Plane edges;
    Plane points;
};

FlipColor colorAt(const Appearance& appearance, int x, int y) {
    return {appearance.color[0].row(y)[x], appearance.color[1].row(y)[x], appearance.color[2].row(y)[x]};
}

/// As a screen shows it that has 8 bits.
std::uint8_t over(std::uint8_t component, std::uint8_t alpha, std::uint8_t background) {
    return static_cast<std::uint8_t>((component * alpha + background * (255 - alpha) + 127) / 255);
}

Tile grown(const Tile& tile, int reach) {
    return {0, 0, tile.width + 2 * reach, tile.height + 2 * reach};
}

std::vector<Plane> planesOf(std::size_t count, int width, int height) {
    return {count, Plane(width, height)};
}

class FlipMetric : public PixelMetric {
public:
    FlipMetric(double pixelsPerDegree, bool opaque, const Tile& maxTile)
        : opaque_(opaque)
        , reach_(flipReach(pixelsPerDegree))
        , contrast_(contrastFilters(pixelsPerDegree))
        , features_(featureFilters(pixelsPerDegree))
        , opponents_(planesOf(3, grown(maxTile, reach_).width, grown(maxTile, reach_).height))
        , across_(planesOf(4, maxTile.width, grown(maxTile, reach_).height))
        , rows_(planesOf(4, maxTile.width, 1))
        , expected_(maxTile)
        , actual_(maxTile) {}

    [[nodiscard]] int reach() const override { return reach_; }

    void measure(const TilePixels& pixels, std::span<float> values) override {
        std::ranges::fill(values, 0.0F);
        if (opaque_)
            return measureOver({}, pixels, values);
        measureOver(std::uint8_t{0}, pixels, values);
        measureOver(std::uint8_t{255}, pixels, values);
    }

private:
    using Background = std::optional<std::uint8_t>;

    void measureOver(Background background, const TilePixels& pixels, std::span<float> values) {
        look(pixels.expected, background, pixels, expected_);
        look(pixels.actual, background, pixels, actual_);
        std::size_t i = 0;
        for (int y = 0; y < pixels.tile.height; ++y)
            for (int x = 0; x < pixels.tile.width; ++x, ++i)
                values[i] = std::max(values[i], errorAt(x, y));
    }

    void look(const std::vector<PixelBytes>& picture, Background background, const TilePixels& pixels,
              Appearance& appearance) {
        readOpponents(picture, background, pixels);
        findColors(pixels, appearance);
        findFeatures(pixels, appearance);
    }

    void readOpponents(const std::vector<PixelBytes>& picture, Background background,
                       const TilePixels& pixels) {
        std::size_t i = 0;
        for (int y = 0; y < pixels.height(); ++y) {
            float* const rows[3]{opponents_[0].row(y), opponents_[1].row(y), opponents_[2].row(y)};
            for (int x = 0; x < pixels.width(); ++x, ++i) {
                FlipColor light{};
                for (std::size_t c = 0; c < 3; ++c) {
                    const std::uint8_t stored =
                        background ? over(picture[i][c], picture[i][3], *background) : picture[i][c];
                    light[c] = table_.exactLight[stored];
                }
                const FlipColor opponent = opponentOf(light);
                for (std::size_t c = 0; c < 3; ++c)
                    rows[c][x] = opponent[c];
            }
        }
    }

    void filterAll(std::size_t channel, const FilterTaps& filter, std::size_t to, const TilePixels& pixels) {
        filterAcross(opponents_[channel], reach_ - filter.reach, filter.taps, across_[to], pixels.tile.width,
                     pixels.height());
    }

    /// Of one row of the tile, into the row `to`.
    const float* filterOne(std::size_t from, const FilterTaps& filter, int y, std::size_t to, int width) {
        const Plane& plane = across_[from];
        filterRow(plane.row(y + reach_ - filter.reach), plane.stride(), filter.taps, rows_[to].row(0), width);
        return rows_[to].row(0);
    }

    void findColors(const TilePixels& pixels, Appearance& appearance) {
        filterAll(0, contrast_.achromatic, 0, pixels);
        filterAll(1, contrast_.redGreen, 1, pixels);
        filterAll(2, contrast_.blueYellow[0], 2, pixels);
        filterAll(2, contrast_.blueYellow[1], 3, pixels);
        const int width = pixels.tile.width;
        for (int y = 0; y < pixels.tile.height; ++y) {
            const float* const achromatic = filterOne(0, contrast_.achromatic, y, 0, width);
            const float* const redGreen = filterOne(1, contrast_.redGreen, y, 1, width);
            const float* const wide = filterOne(2, contrast_.blueYellow[0], y, 2, width);
            const float* const narrow = filterOne(3, contrast_.blueYellow[1], y, 3, width);
            for (int x = 0; x < width; ++x) {
                const float blueYellow =
                    wide[x] * contrast_.blueYellowShare[0] + narrow[x] * contrast_.blueYellowShare[1];
                const FlipColor color = huntLabOf(lightOfOpponent({achromatic[x], redGreen[x], blueYellow}));
                for (std::size_t c = 0; c < 3; ++c)
                    appearance.color[c].row(y)[x] = color[c];
            }
        }
    }

    /// Of Y between 0 and 1; what is added to it leaves the derivatives as they are.
    void findFeatures(const TilePixels& pixels, Appearance& appearance) {
        filterAll(0, features_.smooth, 0, pixels);
        filterAll(0, features_.first, 1, pixels);
        filterAll(0, features_.second, 2, pixels);
        const int width = pixels.tile.width;
        for (int y = 0; y < pixels.tile.height; ++y) {
            const float* const edgeX = filterOne(1, features_.smooth, y, 0, width);
            const float* const edgeY = filterOne(0, features_.first, y, 1, width);
            const float* const pointX = filterOne(2, features_.smooth, y, 2, width);
            const float* const pointY = filterOne(0, features_.second, y, 3, width);
            for (int x = 0; x < width; ++x) {
                appearance.edges.row(y)[x] = std::sqrt(edgeX[x] * edgeX[x] + edgeY[x] * edgeY[x]) / 116;
                appearance.points.row(y)[x] = std::sqrt(pointX[x] * pointX[x] + pointY[x] * pointY[x]) / 116;
            }
        }
    }

    [[nodiscard]] float errorAt(int x, int y) const {
        const float distance = hyab(colorAt(expected_, x, y), colorAt(actual_, x, y));
        if (!(distance > 0))
            return 0;
        const float power = std::pow(distance, colorExponent);
        const float split = colorSplit * maxPower_;
        const float color =
            power < split ? power * colorSplitValue / split
                          : colorSplitValue + (power - split) / (maxPower_ - split) * (1 - colorSplitValue);
        const float feature = std::max(std::abs(expected_.edges.row(y)[x] - actual_.edges.row(y)[x]),
                                       std::abs(expected_.points.row(y)[x] - actual_.points.row(y)[x]));
        if (!(feature > 0))
            return std::min(color, 1.0F);
        const float amplified = std::pow(feature / std::sqrt(2.0F), featureExponent);
        return std::min(std::pow(color, 1 - amplified), 1.0F);
    }

    const LinearLight& table_ = LinearLight::table();
    /// Of the two colours of a screen that are the farthest apart, green and blue.
    const float maxPower_ =
        std::pow(hyab(huntLabOf(FlipColor{0, 1, 0}), huntLabOf(FlipColor{0, 0, 1})), colorExponent);
    bool opaque_;
    int reach_;
    ContrastFilters contrast_;
    FeatureFilters features_;
    std::vector<Plane> opponents_;
    std::vector<Plane> across_;
    std::vector<Plane> rows_;
    Appearance expected_;
    Appearance actual_;
};

} // namespace

std::unique_ptr<PixelMetric> makeFlip(double pixelsPerDegree, bool opaque, const Tile& maxTile) {
    return std::make_unique<FlipMetric>(pixelsPerDegree, opaque, maxTile);
}

} // namespace texplorer
