#include "tests/core/compare/metric_maps.h"
#include "texplorer/compare/comparison.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/image/convert.h"

#include <gmock/gmock.h>

#include <numeric>
#include <random>

namespace texplorer::comparison_test {
namespace {

using test::even;
using test::setPixel;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr PixelBytes grey{100, 100, 100, 255};
constexpr PixelBytes white{255, 255, 255, 255};
constexpr PixelBytes black{0, 0, 0, 255};

Image noise(int width, int height, unsigned seed) {
    std::minstd_rand dice(seed);
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (std::byte& each : image.pixels)
        each = static_cast<std::byte>(dice() >> 8U & 255U);
    return image;
}

Criterion tolerating(double tolerance, double share = 0) {
    Criterion criterion;
    criterion.tolerance = tolerance;
    criterion.share = share;
    return criterion;
}

PixelBytes pixelOf(const Image& image, int x, int y) {
    return rgbaOf(image.format, image.at(x, image.height - 1 - y).data());
}

TEST(Comparison, SaysWhatDiffersWhereAndHowMuch) {
    const Image expected = even(40, 30, grey);
    Image actual = expected;
    setPixel(actual, 7, 4, {100, 130, 100, 255});
    setPixel(actual, 8, 5, {100, 100, 40, 255});
    setPixel(actual, 30, 20, {102, 100, 100, 255});
    setPixel(actual, 0, 29, {101, 100, 100, 255});
    const Result<Comparison> found = comparePictures(expected, actual, tolerating(1));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->alike);
    EXPECT_EQ(found->pixels, 1200U);
    EXPECT_EQ(found->over, 3U);
    EXPECT_EQ(found->worst, (ComparedPixel{{8, 5}, grey, {100, 100, 40, 255}, 60}));
    EXPECT_EQ(found->bounds, (PixelRect{7, 4, 24, 17}));
    EXPECT_EQ(found->regions, 2U);
    EXPECT_THAT(found->largest,
                ElementsAre(DifferentRegion{{7, 4, 2, 2}, 2}, DifferentRegion{{30, 20, 1, 1}, 1}));
    EXPECT_EQ(found->difference.max, 60);
    EXPECT_EQ(found->difference.worst, glm::ivec2(8, 24));
    EXPECT_EQ(found->difference.over, 3U);
    EXPECT_DOUBLE_EQ(found->score, (30 + 60 + 2 + 1) / 4800.0);
    EXPECT_EQ(
        found->sentence,
        "3 of 1200 pixels (0.25 %) have a difference above 1/255; the worst, 60/255, is at 8, 5: 100 100 100 255 "
        "was expected, 100 100 40 255 found; 2 regions within 24 × 17 pixels at 7, 4");
}

TEST(Comparison, SaysThatTheyAreAlike) {
    const Image expected = even(10, 10, grey);
    Image actual = expected;
    EXPECT_TRUE(comparePictures(expected, actual)->alike);
    EXPECT_EQ(comparePictures(expected, actual)->sentence, "alike: none of 100 pixels differs");
    setPixel(actual, 3, 2, {100, 102, 100, 255});
    EXPECT_FALSE(comparePictures(expected, actual)->alike);
    EXPECT_EQ(comparePictures(expected, actual)->sentence,
              "1 of 100 pixels (1 %) differs; the worst, 2/255, is at 3, 2: 100 100 100 255 was expected, "
              "100 102 100 255 found");
    EXPECT_FALSE(comparePictures(expected, actual, tolerating(1.9))->alike);
    EXPECT_TRUE(comparePictures(expected, actual, tolerating(2))->alike);
    EXPECT_EQ(
        comparePictures(expected, actual, tolerating(2))->sentence,
        "alike within 2/255: the worst, 2/255, is at 3, 2: 100 100 100 255 was expected, 100 102 100 255 found");
    EXPECT_FALSE(comparePictures(expected, actual, tolerating(0, 0.0099))->alike);
    EXPECT_TRUE(comparePictures(expected, actual, tolerating(0, 0.01))->alike);
    EXPECT_THAT(comparePictures(expected, actual, tolerating(0, 0.01))->sentence,
                testing::StartsWith("alike, since up to 1 % may differ: 1 of 100 pixels (1 %) differs; "));
}

TEST(Comparison, TakesTwoSizesAsADifference) {
    const Result<Comparison> found = comparePictures(even(300, 200, grey), even(300, 201, grey));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->alike);
    EXPECT_FALSE(found->sameSize());
    EXPECT_EQ(found->sentence, "the sizes differ: 300 × 200 pixels were expected, 300 × 201 found");
}

TEST(Comparison, CountsAlphaUnlessToldNotTo) {
    const Image expected = even(4, 4, {1, 2, 3, 200});
    const Image actual = even(4, 4, {1, 2, 3, 20});
    Criterion rgb;
    rgb.compared = Compared::Rgb;
    EXPECT_EQ(comparePictures(expected, actual)->over, 16U);
    EXPECT_TRUE(comparePictures(expected, actual, rgb)->alike);
    for (const Metric metric : {Metric::Ssim, Metric::Flip})
        EXPECT_FALSE(comparePictures(expected, actual, criterionOf(metric))->alike) << rowOf(metric).name;
}

TEST(Comparison, SeesFormatsAsOpenGLDoes) {
    const Image luminance{PixelFormat::Luminance8, 2, 1, 1, {std::byte{7}, std::byte{9}}};
    Image rgba = even(2, 1, {7, 7, 7, 255});
    setPixel(rgba, 1, 0, {9, 9, 9, 255});
    EXPECT_TRUE(comparePictures(luminance, rgba)->alike);
    const Image alpha{PixelFormat::Alpha8, 1, 1, 1, {std::byte{7}}};
    EXPECT_TRUE(comparePictures(alpha, even(1, 1, {0, 0, 0, 7}))->alike);
}

class OfEveryMetric : public testing::TestWithParam<Metric> {};

TEST_P(OfEveryMetric, TilesLeaveNoTrace) {
    const Image expected = noise(531, 277, 1);
    const Image actual = noise(531, 277, 2);
    const Criterion criterion = criterionOf(GetParam());
    const std::vector<float> whole = test::valuesOf(expected, actual, criterion);
    const Result<Comparison> found = comparePictures(expected, actual, criterion);
    ASSERT_TRUE(found);
    const auto worst = std::ranges::max_element(whole);
    EXPECT_EQ(found->worst.value, static_cast<double>(*worst));
    EXPECT_EQ(found->worst.at.y * 531 + found->worst.at.x, worst - whole.begin());
    std::size_t over = 0;
    for (const float value : whole)
        over += static_cast<double>(value) > criterion.tolerance ? 1 : 0;
    EXPECT_EQ(found->over, over);
    if (GetParam() != Metric::Absolute) {
        const double mean =
            std::accumulate(whole.begin(), whole.end(), 0.0) / static_cast<double>(whole.size());
        EXPECT_NEAR(found->score, GetParam() == Metric::Ssim ? 1 - mean : mean, 1e-9);
    }
}

TEST_P(OfEveryMetric, IsTheSameWhateverTheThreads) {
    const Image expected = noise(600, 300, 1);
    Image actual = expected;
    for (int i = 0; i < 300; ++i)
        setPixel(actual, i * 2, i, white);
    const Criterion criterion = criterionOf(GetParam());
    ComparisonWork one;
    one.threads = 1;
    ComparisonWork many;
    many.threads = 7;
    const Comparison a = *comparePictures(expected, actual, criterion, nullptr, one);
    const Comparison b = *comparePictures(expected, actual, criterion, nullptr, many);
    EXPECT_EQ(a.score, b.score);
    EXPECT_EQ(a.worst, b.worst);
    EXPECT_EQ(a.bounds, b.bounds);
    EXPECT_EQ(a.largest, b.largest);
    EXPECT_EQ(a.map, b.map);
    EXPECT_EQ(a.sentence, b.sentence);
    EXPECT_EQ(a.difference.worst, b.difference.worst);
}

TEST_P(OfEveryMetric, WorksOnTinyPictures) {
    const Criterion criterion = criterionOf(GetParam());
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {1, 40}, {40, 1}}) {
        const Image a = even(width, height, white);
        const Image b = even(width, height, black);
        const Result<Comparison> same = comparePictures(a, a, criterion);
        ASSERT_TRUE(same);
        EXPECT_TRUE(same->alike);
        EXPECT_EQ(same->score, factsOf(GetParam()).alikeScore);
        const Result<Comparison> other = comparePictures(a, b, criterion);
        ASSERT_TRUE(other);
        EXPECT_FALSE(other->alike);
        EXPECT_EQ(other->over, static_cast<std::size_t>(width * height));
        EXPECT_EQ(other->bounds, (PixelRect{0, 0, width, height}));
        EXPECT_EQ(other->worst.at, glm::ivec2(0));
        EXPECT_LE(other->worst.value, factsOf(GetParam()).maxValue);
    }
    const Result<Comparison> none = comparePictures({}, {}, criterion);
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->alike);
}

TEST_P(OfEveryMetric, LeavesOutWhatTheMaskCovers) {
    const Image expected = even(20, 10, grey);
    Image actual = expected;
    Image mask = even(20, 10, {1, 0, 0, 1}); // neither black nor wholly transparent
    setPixel(actual, 3, 3, white);
    setPixel(mask, 3, 3, {0, 0, 0, 255});
    setPixel(actual, 5, 3, black);
    setPixel(mask, 5, 3, {255, 255, 255, 0});
    const Result<Comparison> found = comparePictures(expected, actual, criterionOf(GetParam()), &mask);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->alike);
    EXPECT_EQ(found->pixels, 198U);
    EXPECT_EQ(found->difference.max, 0);
    EXPECT_EQ(found->score, factsOf(GetParam()).alikeScore);
    EXPECT_EQ(pixelOf(found->map, 3, 3), (PixelBytes{72, 72, 72, 255}));
    EXPECT_EQ(pixelOf(found->map, 4, 3), black);
    setPixel(actual, 12, 7, white);
    EXPECT_FALSE(comparePictures(expected, actual, criterionOf(GetParam()), &mask)->alike);
}

TEST_P(OfEveryMetric, StopsWhenAsked) {
    std::stop_source stop;
    ComparisonWork work;
    work.stop = stop.get_token();
    work.threads = 1;
    int reports = 0;
    work.report = [&](float done) {
        EXPECT_GT(done, 0);
        EXPECT_LE(done, 1);
        if (++reports == 2)
            stop.request_stop();
    };
    const Image a = even(1000, 400, grey);
    const Result<Comparison> found = comparePictures(a, a, criterionOf(GetParam()), nullptr, work);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(reports, 2);
}

TEST_P(OfEveryMetric, PaintsWhatIsOverTheToleranceAsSuch) {
    const Image expected = noise(70, 20, 1);
    Image actual = expected;
    for (int x = 0; x < 70; ++x)
        setPixel(actual, x, 10, {static_cast<std::uint8_t>(x * 3), 90, 90, 255});
    Criterion criterion = criterionOf(GetParam());
    criterion.tolerance = GetParam() == Metric::Absolute ? 60 : 0.3;
    const std::vector<float> values = test::valuesOf(expected, actual, criterion);
    const Result<Comparison> found = comparePictures(expected, actual, criterion);
    ASSERT_TRUE(found);
    int over = 0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 70; ++x) {
            const float value = values[static_cast<std::size_t>(y * 70 + x)];
            const bool isOver = static_cast<double>(value) > criterion.tolerance;
            over += isOver ? 1 : 0;
            const PixelBytes color = pixelOf(found->map, x, y);
            EXPECT_EQ(color == black, value == 0) << x << ", " << y << ": " << value;
            EXPECT_EQ(color[0] > 100, isOver) << x << ", " << y << ": " << value; // violet and all above it
        }
    EXPECT_GT(over, 5);
    ComparisonWork noMap;
    noMap.map = false;
    EXPECT_TRUE(comparePictures(expected, actual, criterion, nullptr, noMap)->map.empty());
}

INSTANTIATE_TEST_SUITE_P(All, OfEveryMetric, testing::Values(Metric::Absolute, Metric::Ssim, Metric::Flip),
                         [](const auto& test) { return std::string(rowOf(test.param).label.substr(0, 4)); });

TEST(Comparison, RefusesWhatCanNotBeCompared) {
    const Image a = even(4, 3, grey);
    const auto errorOf = [&](const Criterion& criterion, const Image* mask) {
        const Result<Comparison> found = comparePictures(a, a, criterion, mask);
        return found ? std::string("none") : describe(found.error()).english();
    };
    const Image small = even(4, 2, white);
    EXPECT_EQ(errorOf({}, &small),
              "the mask must be as large as the pictures: expected 4 × 3 pixels, found 4 × 2");
    const Image all = even(4, 3, black);
    EXPECT_EQ(errorOf({}, &all), "the mask leaves no pixel to compare");
    EXPECT_EQ(errorOf(tolerating(-1), nullptr), "tolerance: expected a number from 0 to 255, found -1");
    EXPECT_EQ(errorOf(tolerating(0, 2), nullptr), "share: expected a number from 0 to 1, found 2");
    const Image volume = Image::uninitialised(PixelFormat::Rgba8, 4, 3, 2);
    EXPECT_EQ(comparePictures(a, volume).error().code, ErrorCode::Unsupported);
    EXPECT_THAT(comparePictures(volume, a).error().message, HasSubstr("2 slices"));
    EXPECT_EQ(comparePictures(a, Image::uninitialised(PixelFormat::Depth32, 4, 3)).error().code,
              ErrorCode::Unsupported);
}

TEST(Comparison, SaysHowMuchMemoryItTakes) {
    const glm::ivec2 largest{16384, 16384};
    const std::uint64_t map = std::uint64_t{16384} * 16384 * 4;
    ComparisonWork work;
    work.threads = 2;
    for (const Metric metric : {Metric::Absolute, Metric::Ssim, Metric::Flip}) {
        EXPECT_GT(comparisonBytes(largest, criterionOf(metric), work), map);
        EXPECT_LT(comparisonBytes(largest, criterionOf(metric), work), map + (64U << 20U));
    }
    work.map = false;
    EXPECT_LT(comparisonBytes(largest, criterionOf(Metric::Flip), work), 64U << 20U);
}

} // namespace
} // namespace texplorer::comparison_test
