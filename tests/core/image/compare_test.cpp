#include "core/base/file_io.h"
#include "core/codec/png/png.h"
#include "core/image/compare.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace texplorer::compare_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Rgba8 from grey pixels, bottom row first; their alpha is 255.
Image grey(int width, int height, std::initializer_list<int> values) {
    Image image{PixelFormat::Rgba8, width, height, 1, {}};
    for (const int value : values) {
        for (int c = 0; c < 3; ++c)
            image.pixels.push_back(static_cast<std::byte>(value));
        image.pixels.push_back(std::byte{255});
    }
    return image;
}

TEST(Compare, CountsMeasuresAndFindsTheWorst) {
    const Image a = grey(3, 2, {0, 10, 20, 30, 40, 255});
    Image b = grey(3, 2, {0, 11, 18, 30, 70, 255});
    b.at(2, 1)[0] = std::byte{225}; // red alone: 30 as well, but not the first
    const Result<Difference> difference = compare(a, b, 1);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->max, 30);
    EXPECT_EQ(difference->worst, glm::ivec2(1, 1));
    EXPECT_EQ(difference->over, 3U);
    EXPECT_EQ(difference->pixels, 6U);
    EXPECT_DOUBLE_EQ(difference->shareOver(), 0.5);
    EXPECT_DOUBLE_EQ(difference->mean, (3 * (1 + 2 + 30) + 30) / 24.0);
    EXPECT_EQ(difference->histogram[0], 2U);
    EXPECT_EQ(difference->histogram[30], 2U);
    EXPECT_EQ(difference->countOver(0), 4U);
    EXPECT_EQ(difference->countOver(2), 2U);
    EXPECT_EQ(difference->countOver(30), 0U);
}

TEST(Compare, CountsAlphaUnlessToldNotTo) {
    const Image a = grey(2, 1, {7, 8});
    Image b = a;
    b.at(1, 0)[3] = std::byte{200};
    EXPECT_EQ(compare(a, b, 0)->over, 1U);
    EXPECT_EQ(compare(a, b, 0)->max, 55);
    EXPECT_EQ(compare(a, b, 0, Compared::Rgb)->over, 0U);
    EXPECT_EQ(heatMap(a, b, {}, Compared::Rgb)->pixels, heatMap(a, a)->pixels);
}

TEST(Compare, RefusesWhatCanNotBeCompared) {
    const Image a = grey(2, 1, {1, 2});
    const Result<Difference> sizes = compare(a, grey(1, 2, {1, 2}), 0);
    ASSERT_FALSE(sizes);
    EXPECT_EQ(sizes.error().code, ErrorCode::OutOfRange);
    EXPECT_THAT(sizes.error().message, HasSubstr("found 2 x 1 pixels (RGBA, 8 bits each) and 1 x 2"));
    const Image rgb = Image::uninitialised(PixelFormat::Rgb8, 2, 1);
    EXPECT_EQ(compare(a, rgb, 0).error().code, ErrorCode::Unsupported);
    EXPECT_EQ(heatMap(rgb, a).error().code, ErrorCode::Unsupported);
}

TEST(Compare, TakesPicturesWithoutPixels) {
    const Result<Difference> none = compare({}, {}, 0);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->pixels, 0U);
    EXPECT_EQ(none->shareOver(), 0);
    EXPECT_TRUE(heatMap({}, {})->empty());
}

// --- ImageMagick says the same

double magick(const std::string& arguments) {
    // Its number between 0 and 1 stands in brackets; a count (AE) stands alone.
    FILE* output = popen(("compare " + arguments + " null: 2>&1").c_str(), "r");
    std::string text;
    for (int c = 0; output && (c = std::fgetc(output)) != EOF;)
        text.push_back(static_cast<char>(c));
    if (output)
        pclose(output);
    const std::size_t bracket = text.find('(');
    try {
        return std::stod(bracket == std::string::npos ? text : text.substr(bracket + 1));
    } catch (const std::exception&) {
        ADD_FAILURE() << "compare " << arguments << " said: " << text;
        return -1;
    }
}

TEST(Compare, SaysWhatImageMagickSays) {
    // ImageMagick weighs colours with alpha: so they are opaque here, and alpha comes second.
    std::minstd_rand dice(4);
    Image a = Image::uninitialised(PixelFormat::Rgba8, 37, 23);
    for (std::byte& each : a.pixels)
        each = static_cast<std::byte>(dice() & 255U);
    Image b = a;
    for (std::byte& each : b.pixels)
        if (dice() % 5 == 0)
            each = static_cast<std::byte>(
                std::min<std::size_t>(255, std::to_integer<std::size_t>(each) + dice() % 40));
    const auto opaque = [](Image image) {
        for (std::size_t i = 3; i < image.pixels.size(); i += 4)
            image.pixels[i] = std::byte{255};
        return image;
    };
    const auto alphaAlone = [](Image image) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = i % 4 == 3 ? image.pixels[i] : std::byte{255};
        return image;
    };
    const test::TempDir folder;
    const std::string files =
        "'" + (folder.path() / "a.png").string() + "' '" + (folder.path() / "b.png").string() + "'";
    const auto write = [&](const Image& first, const Image& second) {
        ASSERT_TRUE(writeFileAtomically(folder.path() / "a.png", *encodePng(first)));
        ASSERT_TRUE(writeFileAtomically(folder.path() / "b.png", *encodePng(second)));
    };

    write(opaque(a), opaque(b));
    const Difference colors = *compare(opaque(a), opaque(b), 0);
    EXPECT_EQ(static_cast<double>(colors.over), magick("-metric AE " + files));
    EXPECT_NEAR(colors.max / 255.0, magick("-channel RGB -metric PAE " + files), 1e-4);
    EXPECT_NEAR(compare(a, b, 0, Compared::Rgb)->mean / 255, magick("-channel RGB -metric MAE " + files),
                1e-5);

    write(alphaAlone(a), alphaAlone(b));
    const Difference alpha = *compare(alphaAlone(a), alphaAlone(b), 0);
    EXPECT_GT(alpha.over, 0U);
    EXPECT_NEAR(alpha.max / 255.0, magick("-channel A -metric PAE " + files), 1e-4);
    EXPECT_NEAR(alpha.mean * 4 / 255, magick("-channel A -metric MAE " + files), 1e-5);
}

// --- The heat map

/// CIE lightness, 0 to 100, of an sRGB colour.
double lightness(std::array<std::uint8_t, 4> color) {
    const auto linear = [](std::uint8_t value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

struct Scale {
    const char* name;
    HeatScale scale;
};
class Heat : public testing::TestWithParam<Scale> {};

TEST_P(Heat, RunsFromBlackToBrightWithoutAStepBack) {
    const HeatScale scale = GetParam().scale;
    EXPECT_THAT(heatColor(0, scale), ElementsAre(0, 0, 0, 255));
    double before = 0;
    for (int i = 1; i <= scale.top; ++i) {
        const double now = lightness(heatColor(static_cast<float>(i), scale));
        EXPECT_GE(now, before) << i;
        before = now;
    }
    EXPECT_GT(before, 95);
    EXPECT_EQ(heatColor(300, scale), heatColor(static_cast<float>(scale.top), scale));
    EXPECT_EQ(heatColor(-1, scale), heatColor(0, scale));
    EXPECT_EQ(heatColor(NAN, scale), heatColor(0, scale));
    for (const float difference : {0.5F, 1.0F, 7.0F, 255.0F}) // no tolerance is less than none
        EXPECT_EQ(heatColor(difference, {-3, 255}), heatColor(difference, {0, 255})) << difference;
}

// One sees at a glance whether a pixel is over the tolerance.
TEST_P(Heat, JumpsAtTheTolerance) {
    const auto tolerance = static_cast<float>(GetParam().scale.tolerance);
    const double last = lightness(heatColor(tolerance, GetParam().scale));
    EXPECT_LT(last, 21);
    EXPECT_GT(lightness(heatColor(tolerance + 1, GetParam().scale)), last + 8);
}

INSTANTIATE_TEST_SUITE_P(All, Heat,
                         testing::Values(Scale{"ToleranceOne", {}}, Scale{"ToleranceNone", {0, 255}},
                                         Scale{"Close", {2, 16}}, Scale{"Wide", {20, 200}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(HeatMap, ColorsEachPixelByItsWorstComponent) {
    const Image a = grey(2, 2, {0, 50, 100, 150});
    Image b = grey(2, 2, {0, 51, 105, 150});
    b.at(1, 1)[2] = std::byte{250}; // blue: 100
    const Result<Image> map = heatMap(a, b, {2, 128});
    ASSERT_TRUE(map);
    const auto is = [&](int x, int y, int difference) {
        const auto color = heatColor(static_cast<float>(difference), {2, 128});
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_EQ(std::to_integer<int>(map->at(x, y)[c]), color[c]) << x << ", " << y;
    };
    is(0, 0, 0);
    is(1, 0, 1);
    is(0, 1, 5);
    is(1, 1, 100);
}

} // namespace
} // namespace texplorer::compare_test
