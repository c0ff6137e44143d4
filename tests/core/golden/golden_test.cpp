#include "tests/core/compare/metric_maps.h"
#include "tests/support/python.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/texture_file.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/files/file_io.h"
#include "texplorer/golden/golden.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>

namespace texplorer::golden_test {
namespace {

namespace fs = std::filesystem;
using test::even;
using test::setPixel;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

constexpr PixelBytes grey{100, 100, 100, 255};

/// A folder with a golden, and one for failures.
struct Golden : testing::Test {
    test::TempDir folder;
    Image picture = even(8, 6, grey);
    GoldenOptions options{.failures = folder / "failures"};

    [[nodiscard]] fs::path golden() const { return folder / "start.png"; }
    void store() const { ASSERT_TRUE(saveTexture(textureOf(picture, {}), golden())); }
    [[nodiscard]] std::vector<std::string> left() const {
        std::vector<std::string> names;
        if (fs::exists(options.failures))
            for (const auto& each : fs::directory_iterator(options.failures))
                names.push_back(each.path().filename().string());
        return names;
    }
    [[nodiscard]] Image leftPicture(const char* name) const {
        Result<TextureImage> file = loadTexture(options.failures / name);
        return file ? uprightImage(*std::move(file)) : Image{};
    }
    /// The sentence of a check that must not be possible.
    [[nodiscard]] std::string complaint(const Image& image) const {
        const Result<GoldenCheck> check = checkGolden(image, golden(), options);
        return check ? "it was possible: " + check->message : describe(check.error()).english();
    }
};

TEST_F(Golden, IsMetAndLeavesNothing) {
    store();
    const Result<GoldenCheck> check = checkGolden(picture, golden(), options);
    ASSERT_TRUE(check);
    EXPECT_TRUE(check->alike);
    EXPECT_FALSE(check->written);
    EXPECT_THAT(left(), IsEmpty());
}

TEST_F(Golden, ThatDiffersLeavesThreePicturesAndSaysWhere) {
    store();
    Image actual = picture;
    setPixel(actual, 2, 1, {103, 100, 100, 255});
    const Result<GoldenCheck> check = checkGolden(actual, golden(), options);
    ASSERT_TRUE(check);
    EXPECT_FALSE(check->alike);
    EXPECT_THAT(check->message, AllOf(HasSubstr("1 of 48 pixels"), HasSubstr("3/255"), HasSubstr("at 2, 1"),
                                      HasSubstr(golden().string()), HasSubstr("TEXPLORER_UPDATE_GOLDENS=1")));
    EXPECT_THAT(left(),
                UnorderedElementsAre("start-actual.png", "start-expected.png", "start-difference.png"));
    for (const std::string& name : left())
        EXPECT_THAT(check->message, HasSubstr((options.failures / name).string()));
    EXPECT_EQ(leftPicture("start-actual.png"), actual);
    EXPECT_EQ(leftPicture("start-expected.png"), picture);
    const Image difference = leftPicture("start-difference.png");
    ASSERT_EQ(difference.width, 8);
    const auto at = [&difference](int x, int y) {
        const ByteView pixel = difference.at(x, y);
        return std::vector<std::byte>(pixel.begin(), pixel.begin() + 3);
    };
    EXPECT_EQ(at(0, 0), std::vector<std::byte>(3)) << "black where nothing differs";
    EXPECT_NE(at(2, 4), std::vector<std::byte>(3));

    // Within the tolerance, where the mask is, or where a share may differ, it is met again, and cleans up.
    GoldenOptions tolerant = options;
    tolerant.criterion.tolerance = 3;
    EXPECT_TRUE(checkGolden(actual, golden(), tolerant)->alike);
    EXPECT_THAT(left(), IsEmpty());
    tolerant = options;
    tolerant.criterion.share = 1.0 / 48;
    EXPECT_TRUE(checkGolden(actual, golden(), tolerant)->alike);
    tolerant = options;
    tolerant.mask = folder / "mask.png";
    Image mask = even(8, 6, {255, 255, 255, 255});
    setPixel(mask, 2, 1, {0, 0, 0, 255});
    ASSERT_TRUE(saveTexture(textureOf(mask, {}), tolerant.mask));
    EXPECT_TRUE(checkGolden(actual, golden(), tolerant)->alike);
}

TEST_F(Golden, OfAnotherSizeLeavesNoDifference) {
    store();
    const Result<GoldenCheck> check = checkGolden(even(8, 5, grey), golden(), options);
    ASSERT_TRUE(check);
    EXPECT_FALSE(check->alike);
    EXPECT_THAT(check->message, AllOf(HasSubstr("8 × 6"), HasSubstr("8 × 5"), Not(HasSubstr("difference"))));
    EXPECT_THAT(left(), UnorderedElementsAre("start-actual.png", "start-expected.png"));
}

TEST_F(Golden, ThatIsMissingIsSaidAndWrittenWhenAsked) {
    const fs::path missing = folder / "new/deep/start.png";
    Result<GoldenCheck> check = checkGolden(picture, missing, options);
    ASSERT_TRUE(check);
    EXPECT_FALSE(check->alike);
    EXPECT_THAT(check->message, AllOf(HasSubstr("there is no golden"), HasSubstr(missing.string())));
    EXPECT_THAT(left(), UnorderedElementsAre("start-actual.png"));
    EXPECT_FALSE(fs::exists(folder / "new"));

    options.update = true;
    check = checkGolden(picture, missing, options);
    ASSERT_TRUE(check);
    EXPECT_TRUE(check->alike && check->written);
    EXPECT_THAT(left(), IsEmpty());
    EXPECT_EQ(uprightImage(*loadTexture(missing)), picture);
}

TEST_F(Golden, IsWrittenAnewOnlyIfItDiffers) {
    store();
    const Result<Bytes> before = readFile(golden());
    options.update = true;
    Image actual = picture;
    setPixel(actual, 0, 0, {0, 0, 0, 255});
    options.criterion.tolerance = 100;
    EXPECT_FALSE(checkGolden(actual, golden(), options)->written);
    EXPECT_EQ(*readFile(golden()), *before);
    options.criterion.tolerance = 99;
    EXPECT_TRUE(checkGolden(actual, golden(), options)->written);
    EXPECT_EQ(uprightImage(*loadTexture(golden())), actual);

    // A damaged one is no golden, and is replaced only when that is asked for.
    ASSERT_TRUE(writeFileAtomically(golden(), viewBytes("no picture")));
    EXPECT_TRUE(checkGolden(actual, golden(), options)->written);
    ASSERT_TRUE(writeFileAtomically(golden(), viewBytes("no picture")));
    options.update = false;
    EXPECT_THAT(complaint(actual), HasSubstr(golden().string()));
}

TEST_F(Golden, TakesRowsAsOpenGlAndAsOthersHaveThem) {
    // 2 x 3 pixels: the upper left one is red, the lower right one blue. Pillow counts rows from the top.
    std::vector<std::byte> rgba(24, std::byte{255});
    const auto set = [&rgba](std::size_t pixel, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
        rgba[pixel * 4] = std::byte{red};
        rgba[pixel * 4 + 1] = std::byte{green};
        rgba[pixel * 4 + 2] = std::byte{blue};
    };
    set(4, 255, 0, 0);
    set(1, 0, 0, 255);
    options.update = true;
    ASSERT_TRUE(checkGolden(2, 3, rgba, folder / "bottom_first.png", options));
    set(4, 255, 255, 255);
    set(1, 255, 255, 255);
    set(0, 255, 0, 0);
    set(5, 0, 0, 255);
    options.rowsTopFirst = true;
    ASSERT_TRUE(checkGolden(2, 3, rgba, folder / "top_first.png", options));
    EXPECT_TRUE(test::runPython("core/golden/golden_against_pillow.py", folder.path()));
}

TEST_F(Golden, RefusesWhatIsNoFramebuffer) {
    const auto raw = [this](int width, int height, std::size_t bytes) {
        const Result<GoldenCheck> check =
            checkGolden(width, height, std::vector<std::byte>(bytes), golden(), options);
        return check ? check->message : describe(check.error()).english();
    };
    EXPECT_EQ(raw(2, 2, 15), "expected a framebuffer of 2 × 2 pixels with 4 bytes each, found 15 bytes");
    EXPECT_EQ(raw(0, 2, 0), "expected a framebuffer of 0 × 2 pixels with 4 bytes each, found 0 bytes");
    EXPECT_EQ(raw(-1, -4, 16), "expected a framebuffer of -1 × -4 pixels with 4 bytes each, found 16 bytes");
    EXPECT_EQ(raw(2147483647, 2147483647, 4),
              "expected a framebuffer of 2147483647 × 2147483647 pixels with 4 bytes each, found 4 bytes");
    EXPECT_EQ(complaint({}), "expected a framebuffer with pixels, found one of 0 × 0 × 1");
    picture.pixels.pop_back();
    EXPECT_EQ(complaint(picture), "a framebuffer of 8 × 6 pixels needs 192 bytes, found 191");
}

TEST_F(Golden, SaysWhatCannotBeReadOrWritten) {
    store();
    options.mask = folder / "nowhere.png";
    EXPECT_THAT(complaint(picture), HasSubstr("nowhere.png"));
    options.mask = folder / "small.png";
    ASSERT_TRUE(saveTexture(textureOf(even(4, 6, grey), {}), options.mask));
    EXPECT_THAT(complaint(picture), HasSubstr("mask"));
    options.mask.clear();
    options.criterion.tolerance = -1;
    EXPECT_THAT(complaint(picture), HasSubstr("tolerance"));
    options.criterion = {};

    // A failure stays one where its pictures can't be written.
    ASSERT_TRUE(writeFileAtomically(folder / "file", viewBytes("no folder")));
    options.failures = folder / "file/failures";
    Result<GoldenCheck> check = checkGolden(even(8, 6, {0, 0, 0, 255}), golden(), options);
    ASSERT_TRUE(check);
    EXPECT_FALSE(check->alike);
    EXPECT_THAT(check->message, AllOf(HasSubstr("48 of 48 pixels"), HasSubstr("not written: ")));

    options.update = true;
    check = checkGolden(picture, folder / "start.jpg", options);
    ASSERT_FALSE(check);
    EXPECT_THAT(describe(check.error()), AllOf(HasSubstr("start.jpg"), HasSubstr(".png")));
}

TEST_F(Golden, NamesFilesWithoutTheirControlCharacters) {
    const Result<GoldenCheck> check = checkGolden(picture, folder / "a\x1b[31m.png", options);
    ASSERT_TRUE(check);
    EXPECT_THAT(check->message, AllOf(HasSubstr("a\\u001b[31m-actual.png"), Not(HasSubstr("\x1b"))));
}

} // namespace
} // namespace texplorer::golden_test
