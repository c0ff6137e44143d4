#include "tests/support/grey_picture.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <random>
#include <string>

namespace texplorer::difference_test {
namespace {

using testing::HasSubstr;

TEST(Compare, CountsMeasuresAndFindsTheWorst) {
    const Image a = greyPicture(3, 2, {0, 10, 20, 30, 40, 255});
    Image b = greyPicture(3, 2, {0, 11, 18, 30, 70, 255});
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
    const Image a = greyPicture(2, 1, {7, 8});
    Image b = a;
    b.at(1, 0)[3] = std::byte{200};
    EXPECT_EQ(compare(a, b, 0)->over, 1U);
    EXPECT_EQ(compare(a, b, 0)->max, 55);
    EXPECT_EQ(compare(a, b, 0, Compared::Rgb)->over, 0U);
    EXPECT_EQ(heatMap(a, b, {}, Compared::Rgb)->pixels, heatMap(a, a)->pixels);
}

TEST(Compare, RefusesWhatCanNotBeCompared) {
    const Image a = greyPicture(2, 1, {1, 2});
    const Result<Difference> sizes = compare(a, greyPicture(1, 2, {1, 2}), 0);
    ASSERT_FALSE(sizes);
    EXPECT_EQ(sizes.error().code, ErrorCode::OutOfRange);
    EXPECT_THAT(sizes.error().message, HasSubstr("found 2 × 1 pixels (RGBA, 8 bits each) and 1 × 2"));
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

} // namespace
} // namespace texplorer::difference_test
