#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/registry.h"
#include "texplorer/codec/texture_file.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::texture_file_test {
namespace {

using testing::HasSubstr;

/// 1 x 2 pixels, blue at the bottom, red above it.
TextureImage blueBelowRed() {
    Image image = Image::uninitialised(PixelFormat::Rgb8, 1, 2);
    image.pixels = {std::byte{0}, std::byte{0}, std::byte{255}, std::byte{255}, std::byte{0}, std::byte{0}};
    return textureOf(std::move(image), {});
}

TEST(LoadTexture, KnowsAFileByItsContentNotByItsName) {
    const test::TempDir folder;
    test::writeRaw(folder / "red.picture", test::onePixelBmp("\1\2\3"));
    const Result<TextureImage> texture = loadTexture(folder / "red.picture");
    ASSERT_TRUE(texture) << describe(texture.error());
    EXPECT_EQ(texture->format, "BMP");
    const Image& image = std::get<Image>(texture->surface(0, 0));
    EXPECT_EQ(image.width, 1);
    EXPECT_EQ(image.at(0, 0)[0], std::byte{3});
}

TEST(LoadTexture, EveryErrorNamesTheFile) {
    const test::TempDir folder;
    test::writeRaw(folder / "text.bmp", std::string("not a picture"));
    test::writeRaw(folder / "cut.bmp", test::onePixelBmp("\1\2\3").substr(0, 56));
    for (const auto& [name, code] : {std::pair{"none.bmp", ErrorCode::NotFound},
                                     {"text.bmp", ErrorCode::Unsupported},
                                     {"cut.bmp", ErrorCode::Malformed},
                                     {"", ErrorCode::Unreadable}}) {
        const Result<TextureImage> texture = loadTexture(folder / name);
        ASSERT_FALSE(texture) << name;
        EXPECT_EQ(texture.error().code, code) << name;
        EXPECT_EQ(texture.error().where, (folder / name).string());
    }
}

TEST(LoadTexture, TakesNoMoreThanItsLimits) {
    const test::TempDir folder;
    ASSERT_TRUE(saveTexture(blueBelowRed(), folder / "two.bmp"));
    const Result<TextureImage> texture = loadTexture(folder / "two.bmp", {.maxExtent = 1});
    ASSERT_FALSE(texture);
    EXPECT_EQ(texture.error().code, ErrorCode::TooLarge);
}

TEST(SaveTexture, WritesTheFormatThatTheNameAsksFor) {
    const test::TempDir folder;
    for (const char* name : {"a.bmp", "b.DDS", "c.png", "d.tga"}) {
        const Result<void> saved = saveTexture(blueBelowRed(), folder / name);
        ASSERT_TRUE(saved) << describe(saved.error());
        const Result<TextureImage> texture = loadTexture(folder / name);
        ASSERT_TRUE(texture) << describe(texture.error());
        EXPECT_EQ(texture->format, codecForExtension(name)->name);
        Image image = std::get<Image>(texture->surface(0, 0));
        if (texture->topFirst)
            flipVertically(image);
        EXPECT_EQ(image.at(0, 0)[0], std::byte{0}) << name;
        EXPECT_EQ(image.at(0, 1)[0], std::byte{255}) << name;
    }
}

TEST(SaveTexture, RefusesOtherNamesAndNamesThoseThatItTakes) {
    const test::TempDir folder;
    for (const char* name : {"a.jpg", "a", "a.txt"}) {
        const Result<void> saved = saveTexture(blueBelowRed(), folder / name);
        ASSERT_FALSE(saved) << name;
        EXPECT_EQ(saved.error().code, ErrorCode::Unsupported);
        EXPECT_EQ(saved.error().message, "expected a name that ends with one of .bmp, .dds, .png, .tga");
        EXPECT_EQ(saved.error().where, (folder / name).string());
        EXPECT_FALSE(std::filesystem::exists(folder / name));
    }
}

TEST(SaveTexture, KeepsWhatWasThereWhereItFails) {
    const test::TempDir folder;
    test::writeRaw(folder / "old.png", std::string("old"));
    const Result<void> saved = saveTexture(TextureImage{}, folder / "old.png");
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().where, (folder / "old.png").string());
    EXPECT_EQ(readText(folder / "old.png").value(), "old");
    const Result<void> lost = saveTexture(blueBelowRed(), folder / "no" / "a.png");
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().code, ErrorCode::Unwritable);
}

} // namespace
} // namespace texplorer::texture_file_test
