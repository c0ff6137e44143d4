#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::scene_file_test {
namespace {

using testing::HasSubstr;

Bytes pngWith(const std::vector<PictureText>& texts) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, 2, 2);
    std::ranges::fill(image.pixels, std::byte{7});
    const Result<Bytes> png = encodePng(image, {.texts = texts});
    EXPECT_TRUE(png);
    return png.value_or(Bytes());
}

constexpr const char* json = R"({"version": 1})";

TEST(SceneFile, IsTheFileOrTheTextOfAPng) {
    EXPECT_EQ(sceneTextIn(viewBytes(json)).value(), json);
    EXPECT_EQ(sceneTextIn(pngWith({{"Software", "x"}, {sceneKeyword, json}})).value(), json);
    const std::string whole = writeScene(defaultScene()); // long: packed
    EXPECT_EQ(sceneTextIn(pngWith({{sceneKeyword, whole}})).value(), whole);
    const Result<std::string> none = sceneTextIn(pngWith({{"Texplorer scenes", json}}));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotFound);
    EXPECT_THAT(none.error().message, HasSubstr("a PNG without a scene: it has no text \"Texplorer scene\""));
}

TEST(SceneFile, OfAPngAllIsRead) {
    EXPECT_EQ(maxSceneFileBytes(viewBytes(json)), maxSceneBytes);
    EXPECT_EQ(maxSceneFileBytes(pngWith({})), defaultMaxFileBytes);
}

TEST(SceneFile, APictureWithASceneIsToldByItsChunks) {
    const test::TempDir folder;
    const auto holds = [&folder](ByteView bytes) {
        EXPECT_TRUE(writeFileAtomically(folder / "a", bytes));
        return isPictureWithScene(folder / "a");
    };
    const Bytes made = pngWith({{"Software", "x"}, {sceneKeyword, json}});
    EXPECT_TRUE(holds(made));
    EXPECT_EQ(readSceneFile(folder / "a").value().text, json);
    EXPECT_TRUE(holds(pngWith({{sceneKeyword, writeScene(defaultScene())}})));
    EXPECT_FALSE(holds(pngWith({{"Software", sceneKeyword}, {"Texplorer scenes", json}})));
    EXPECT_FALSE(holds(viewBytes(json)));
    EXPECT_FALSE(holds(ByteView(made).first(30)));
    EXPECT_FALSE(isPictureWithScene(folder / "nowhere.png"));
    EXPECT_FALSE(isPictureWithScene(folder.path()));
}

/// As ImageMagick and others write them: behind the pixels.
TEST(SceneFile, TheTextMayComeLast) {
    const test::TempDir folder;
    const Bytes plain = pngWith({});
    const Bytes made = pngWith({{sceneKeyword, json}});
    constexpr std::size_t start = 8 + 25; // signature, IHDR
    constexpr std::size_t end = 12;       // IEND
    const std::size_t textBytes = made.size() - plain.size();
    const auto text = ByteView(made).subspan(start, textBytes);
    Bytes late(plain.begin(), plain.end() - end);
    late.insert(late.end(), text.begin(), text.end());
    late.insert(late.end(), plain.end() - end, plain.end());
    ASSERT_TRUE(writeFileAtomically(folder / "late.png", late));
    EXPECT_TRUE(isPictureWithScene(folder / "late.png"));
    EXPECT_TRUE(isPictureWithScene(folder / "late.png", 3)); // IHDR, IDAT and the text
    EXPECT_FALSE(isPictureWithScene(folder / "late.png", 2));
    EXPECT_EQ(readSceneFile(folder / "late.png").value().text, json);
}

} // namespace
} // namespace texplorer::scene_file_test
