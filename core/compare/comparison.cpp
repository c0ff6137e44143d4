#include "texplorer/compare/comparison.h"

#include "texplorer/base/parallel.h"
#include "texplorer/base/tried.h"
#include "texplorer/compare/flip_filters.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/compare/pixel_difference.h"
#include "texplorer/compare/pixel_metric.h"
#include "texplorer/compare/regions.h"
#include "texplorer/compare/verdict.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <tuple>

namespace texplorer {

namespace {

constexpr int tileWidth = 256; // a multiple of 64, see PixelBits
constexpr int tileHeight = 128;
constexpr std::size_t keptRegions = 8;
constexpr PixelBytes maskedColor{72, 72, 72, 255};

Result<void> checkPicture(const Image& image, std::string_view name) {
    if (image.depth == 1 && image.format != PixelFormat::Depth32)
        return {};
    return fail(ErrorCode::Unsupported,
                Sentence("expected a picture for {0}, found {1} of {2}", name,
                         image.depth == 1 ? "one" : Sentence("{0} slices", image.depth),
                         rowOf(image.format).name));
}

Result<void> checkMask(const Image& expected, const Image& mask) {
    if (Result<void> good = checkPicture(mask, "the mask"); !good)
        return good;
    if (mask.width == expected.width && mask.height == expected.height)
        return {};
    return fail(
        ErrorCode::OutOfRange,
        Sentence("the mask must be as large as the pictures: expected {0} × {1} pixels, found {2} × {3}",
                 expected.width, expected.height, mask.width, mask.height));
}

/// What 1 of a metric's values is in 255ths.
float mapUnit(Metric metric) {
    return metric == Metric::Absolute ? 1.0F : 255.0F;
}

/// The colours of a metric's values: what is above the tolerance is above that of the scale.
class MapColors {
public:
    explicit MapColors(const Criterion& criterion)
        : scale_(mapUnit(criterion.metric))
        , limit_(criterion.tolerance) {
        const HeatScale heat = mapScale(criterion.metric, criterion.tolerance);
        within_ = heat.tolerance * steps;
        above_ = within_ + steps;
        for (std::size_t i = 0; i < colors_.size(); ++i)
            colors_[i] = heatColor(static_cast<float>(i) / steps, heat);
    }

    [[nodiscard]] const PixelBytes& of(float value) const {
        if (value == 0)
            return colors_[0];
        const int step = static_cast<int>(std::lround(std::min(value * scale_, 255.0F) * steps));
        return colors_[static_cast<std::size_t>(static_cast<double>(value) > limit_
                                                    ? std::clamp(step, above_, 256 * steps)
                                                    : std::clamp(step, std::min(1, within_), within_))];
    }

private:
    static constexpr int steps = 8; ///< between two 255ths

    float scale_;
    double limit_;
    int within_ = 0;
    int above_ = 0;
    std::array<PixelBytes, std::size_t{256} * steps + 1> colors_{};
};

/// What a thread has found in its tiles. Joined to another, the order doesn't matter.
struct Findings {
    std::array<std::size_t, 256> histogram{};
    std::size_t componentSum = 0;
    std::size_t pixels = 0;
    std::size_t over = 0;
    glm::ivec2 first{0}; ///< of those above the tolerance; `last` is the first one behind them
    glm::ivec2 last{0};
    std::optional<ComparedPixel> worst;        ///< of all with a value above 0
    std::optional<glm::ivec2> worstDifference; ///< where the difference is `largest`, from the upper left
    int largest = 0;

    void count(const TilePixels& pixels, int x, int y, float value, const Criterion& criterion);
    void add(const Findings& other);

private:
    void addOver(const glm::ivec2& from, const glm::ivec2& to);
    void takeWorst(const ComparedPixel& pixel);
    void takeDifference(int difference, glm::ivec2 at);
};

void Findings::addOver(const glm::ivec2& from, const glm::ivec2& to) {
    first = over == 0 ? from : glm::ivec2(std::min(first.x, from.x), std::min(first.y, from.y));
    last = over == 0 ? to : glm::ivec2(std::max(last.x, to.x), std::max(last.y, to.y));
}

void Findings::takeWorst(const ComparedPixel& pixel) {
    const auto rank = [](const ComparedPixel& each) { return std::tuple(-each.value, each.at.y, each.at.x); };
    if (!worst || rank(pixel) < rank(*worst))
        worst = pixel;
}

/// The first is that of the lowest row, see Difference.
void Findings::takeDifference(int difference, glm::ivec2 at) {
    const auto rank = [](int each, glm::ivec2 place) { return std::tuple(-each, -place.y, place.x); };
    if (!worstDifference || rank(difference, at) < rank(largest, *worstDifference)) {
        worstDifference = at;
        largest = difference;
    }
}

void Findings::count(const TilePixels& tile, int x, int y, float value, const Criterion& criterion) {
    const std::size_t i = tile.index(x, y);
    const glm::ivec2 at{tile.tile.x + x, tile.tile.y + y};
    const PixelDifference difference =
        differenceOf(tile.expected[i].data(), tile.actual[i].data(), componentsOf(criterion.compared));
    ++pixels;
    ++histogram[static_cast<std::size_t>(difference.worst)];
    componentSum += static_cast<std::size_t>(difference.sum);
    if (difference.worst > 0 && difference.worst >= largest)
        takeDifference(difference.worst, at);
    if (value > 0 && (!worst || static_cast<double>(value) >= worst->value))
        takeWorst({at, tile.expected[i], tile.actual[i], static_cast<double>(value)});
    if (static_cast<double>(value) > criterion.tolerance) {
        addOver(at, at + 1);
        ++over;
    }
}

void Findings::add(const Findings& other) {
    for (std::size_t i = 0; i < histogram.size(); ++i)
        histogram[i] += other.histogram[i];
    componentSum += other.componentSum;
    pixels += other.pixels;
    if (other.over > 0)
        addOver(other.first, other.last);
    over += other.over;
    if (other.worst)
        takeWorst(*other.worst);
    if (other.worstDifference)
        takeDifference(other.largest, *other.worstDifference);
}

class Work {
public:
    Work(const PicturePair& pair, const Criterion& criterion, const ComparisonWork& work,
         Comparison& comparison)
        : pair_(pair)
        , criterion_(criterion)
        , work_(work)
        , comparison_(comparison)
        , across_((pair.width() + tileWidth - 1) / tileWidth)
        , down_((pair.height() + tileHeight - 1) / tileHeight)
        , sums_(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_))
        , colors_(criterion)
        , over_(pair.width(), pair.height()) {}

    Result<void> run() {
        const unsigned wanted = work_.threads == 0 ? processorThreads() : work_.threads;
        const std::size_t threads = std::clamp<std::size_t>(sums_.size(), 1, wanted);
        if (work_.map)
            comparison_.map = Image::uninitialised(PixelFormat::Rgba8, pair_.width(), pair_.height());
        const bool opaque = criterion_.compared == Compared::Rgb || criterion_.metric == Metric::Absolute ||
                            isOpaque(threads);
        std::vector<Findings> findings(threads);
        std::atomic<bool> noMemory = false;
        parallelFor(threads, static_cast<unsigned>(threads), [&](std::size_t i) {
            try {
                measureTiles(opaque, findings[i]);
            } catch (const std::bad_alloc&) {
                noMemory = true;
            }
        });
        if (work_.stop.stop_requested())
            return fail(ErrorCode::Cancelled, "the comparison was stopped");
        if (noMemory)
            throw std::bad_alloc();
        for (std::size_t i = 1; i < findings.size(); ++i)
            findings[0].add(findings[i]);
        conclude(findings[0]);
        return {};
    }

private:
    bool isOpaque(std::size_t threads) const {
        std::atomic<bool> opaque = true;
        parallelFor(static_cast<std::size_t>(down_), static_cast<unsigned>(threads), [&](std::size_t i) {
            const int first = static_cast<int>(i) * tileHeight;
            if (opaque && !pair_.isOpaque(first, std::min(tileHeight, pair_.height() - first)))
                opaque = false;
        });
        return opaque;
    }

    [[nodiscard]] Tile tileAt(std::size_t i) const {
        const int x = static_cast<int>(i) % across_ * tileWidth;
        const int y = static_cast<int>(i) / across_ * tileHeight;
        return {x, y, std::min(tileWidth, pair_.width() - x), std::min(tileHeight, pair_.height() - y)};
    }

    void measureTiles(bool opaque, Findings& findings) {
        const Tile largest = tileAt(0);
        const std::unique_ptr<PixelMetric> metric = makePixelMetric(criterion_, opaque, largest);
        TilePixels pixels;
        std::vector<float> values;
        for (std::size_t i = next_++; i < sums_.size() && !work_.stop.stop_requested(); i = next_++) {
            const Tile tile = tileAt(i);
            pair_.read(tile, metric->reach(), pixels);
            values.assign(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height), 0);
            if (std::memcmp(pixels.expected.data(), pixels.actual.data(),
                            pixels.expected.size() * sizeof(PixelBytes)) != 0)
                metric->measure(pixels, values);
            sums_[i] = take(pixels, values, findings);
            if (work_.report)
                work_.report(static_cast<float>(++done_) / static_cast<float>(sums_.size()));
        }
    }

    /// The sum of the values that count.
    double take(const TilePixels& pixels, const std::vector<float>& values, Findings& findings) {
        double sum = 0;
        std::size_t i = 0;
        for (int y = 0; y < pixels.tile.height; ++y)
            for (int x = 0; x < pixels.tile.width; ++x, ++i) {
                const glm::ivec2 at{pixels.tile.x + x, pixels.tile.y + y};
                const bool counts = pixels.counts[i] != 0;
                if (counts) {
                    findings.count(pixels, x, y, values[i], criterion_);
                    sum += static_cast<double>(values[i]);
                    if (static_cast<double>(values[i]) > criterion_.tolerance)
                        over_.set(at.x, at.y);
                }
                if (work_.map)
                    paint(at, counts ? colors_.of(values[i]) : maskedColor);
            }
        return sum;
    }

    void paint(glm::ivec2 at, const PixelBytes& color) {
        const std::span<std::byte> to = comparison_.map.at(at.x, pair_.height() - 1 - at.y);
        std::ranges::copy(std::as_bytes(std::span(color)), to.begin());
    }

    void conclude(const Findings& findings) {
        comparison_.pixels = findings.pixels;
        comparison_.over = findings.over;
        comparison_.worst = findings.worst.value_or(ComparedPixel{});
        if (findings.over > 0)
            comparison_.bounds = {findings.first.x, findings.first.y, findings.last.x - findings.first.x,
                                  findings.last.y - findings.first.y};
        Regions regions = regionsIn(over_, comparison_.bounds, keptRegions);
        comparison_.regions = regions.count;
        comparison_.largest = std::move(regions.largest);

        Difference& difference = comparison_.difference;
        difference.pixels = findings.pixels;
        difference.histogram = findings.histogram;
        difference.max = findings.largest;
        difference.over = difference.countOver(
            criterion_.metric == Metric::Absolute ? static_cast<int>(std::floor(criterion_.tolerance)) : 0);
        if (findings.worstDifference)
            difference.worst = {findings.worstDifference->x,
                                pair_.height() - 1 - findings.worstDifference->y};
        const auto pixels = static_cast<double>(std::max<std::size_t>(1, findings.pixels));
        difference.mean = static_cast<double>(findings.componentSum) / pixels /
                          static_cast<double>(componentsOf(criterion_.compared));

        double sum = 0;
        for (const double each : sums_)
            sum += each;
        const double mean = sum / pixels;
        comparison_.score = criterion_.metric == Metric::Absolute ? difference.mean
                            : criterion_.metric == Metric::Ssim   ? 1 - mean
                                                                  : mean;
        comparison_.alike = comparison_.shareOver() <= criterion_.share;
    }

    const PicturePair& pair_;
    const Criterion& criterion_;
    const ComparisonWork& work_;
    Comparison& comparison_;
    int across_;
    int down_;
    std::vector<double> sums_; ///< of each tile: added up in the order of tiles, not of threads
    MapColors colors_;
    PixelBits over_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<std::size_t> done_ = 0;
};

} // namespace

HeatScale mapScale(Metric metric, double tolerance) {
    const double exact = tolerance * static_cast<double>(mapUnit(metric));
    return {exact > 0 && exact < 1 ? 1 : static_cast<int>(std::floor(exact)), 255};
}

std::uint64_t comparisonBytes(glm::ivec2 size, const Criterion& criterion, const ComparisonWork& work) {
    const auto area = [](int width, int height) {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    };
    int reach = 0;
    std::uint64_t planes = 0;
    if (criterion.metric == Metric::Ssim) {
        reach = 5;
        planes = 9;
    } else if (criterion.metric == Metric::Flip) {
        reach = flipReach(criterion.pixelsPerDegree);
        planes = 14;
    }
    const int width = std::min(size.x, tileWidth) + 2 * reach;
    const int height = std::min(size.y, tileHeight) + 2 * reach;
    const std::uint64_t tiles =
        area((size.x + tileWidth - 1) / tileWidth, (size.y + tileHeight - 1) / tileHeight);
    const std::uint64_t threads =
        std::clamp<std::uint64_t>(tiles, 1, work.threads == 0 ? processorThreads() : work.threads);
    const std::uint64_t perThread = planes * area(width + 16, height + 1) * sizeof(float) + // planes
                                    area(width, height) * (2 * sizeof(PixelBytes) + sizeof(float) + 1);
    const std::uint64_t regions = static_cast<std::uint64_t>(size.x) * 128; // every other pixel of two rows
    return (work.map ? area(size.x, size.y) * sizeof(PixelBytes) : 0) + area((size.x + 63) / 64, size.y) * 8 +
           threads * (perThread + sizeof(Findings)) + tiles * sizeof(double) + regions;
}

Result<Comparison> comparePictures(const Image& expected, const Image& actual, const Criterion& criterion,
                                   const Image* mask, const ComparisonWork& work) {
    for (const auto& [image, name] :
         {std::pair(&expected, "the expected one"), std::pair(&actual, "the actual one")})
        if (const Result<void> good = checkPicture(*image, name); !good)
            return fail(good.error());
    if (const Result<void> good = checkCriterion(criterion); !good)
        return fail(good.error());
    Comparison comparison;
    comparison.criterion = criterion;
    comparison.expectedSize = {expected.width, expected.height};
    comparison.actualSize = {actual.width, actual.height};
    if (mask != nullptr)
        if (const Result<void> good = checkMask(expected, *mask); !good)
            return fail(good.error());
    if (!comparison.sameSize()) {
        comparison.sentence = verdictOn(comparison);
        return comparison;
    }
    const std::string noMemory = fmt::format(
        "not enough memory to compare {} × {} pixels, which needs up to {} MiB", expected.width,
        expected.height, comparisonBytes(comparison.expectedSize, criterion, work) / (1U << 20U) + 1);
    return tried({noMemory, "the pictures can't be compared"}, [&]() -> Result<Comparison> {
        const PicturePair pair(expected, actual, mask);
        if (!expected.empty())
            if (const Result<void> done = Work(pair, criterion, work, comparison).run(); !done)
                return fail(done.error());
        if (comparison.pixels == 0 && !expected.empty())
            return fail(ErrorCode::OutOfRange, "the mask leaves no pixel to compare");
        comparison.alike = comparison.alike || expected.empty();
        comparison.sentence = verdictOn(comparison);
        return std::move(comparison);
    });
}

} // namespace texplorer
