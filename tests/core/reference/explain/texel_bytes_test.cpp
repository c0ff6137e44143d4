#include "texplorer/reference/explain/texel_bytes.h"

#include <gmock/gmock.h>

namespace texplorer::reference::texel_bytes_test {
namespace {

using testing::ElementsAre;

/// 15 × 4 pixels of BGR without padding, each of whose bytes is its place.
TextureLevels levelsOf(const Upload& upload, MipPolicy mipmaps = MipPolicy::None) {
    Texture texture;
    texture.flip = FlipMode::Pixels;
    texture.mipmaps = mipmaps;
    texture.upload = upload;
    texture.upload.custom = true;
    Image image = Image::uninitialised(PixelFormat::Rgb8, 15, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i / 3 * 3 + 2 - i % 3); // red last
    TextureImage file;
    file.format = "TGA";
    file.fileTopFirst = false;
    file.surfaces.emplace_back(std::move(image));
    return *prepareLevels(texture, file);
}

Tap tapAt(int x, int y, int level = 0) {
    return {.level = level, .index = {x, y, 0}};
}

// Rows of 45 bytes, of which OpenGL expects 48: (3, 2) begins at 2 * 48 + 3 * 3.
TEST(BytesOfTexels, AreThoseOfTheirRowAndColumn) {
    const TextureLevels levels = levelsOf({.format = TransferFormat::Rgb});
    const auto bytes = texelBytes(levels, Target::Texture2D, tapAt(3, 2));
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->range, (ByteRange{105, 3}));
    EXPECT_THAT(bytes->values, ElementsAre(105, 106, 107));
    EXPECT_EQ(sentenceOf(*bytes), "memory at byte 105–107: 105 106 107, b g r, read as r g b");
}

TEST(BytesOfTexels, CanBePartsOfTwoPixels) {
    const TextureLevels levels = levelsOf({.format = TransferFormat::Rgba, .alignment = 1});
    EXPECT_EQ(sentenceOf(*texelBytes(levels, Target::Texture2D, tapAt(1, 0))),
              "memory at byte 4–7: 4 5 6 7, g r b g, read as r g b a");
}

// 180 bytes are held; the last row begins at 144 and ends at 189.
TEST(BytesOfTexels, CanBeBeyondTheEnd) {
    const TextureLevels levels = levelsOf({.format = TransferFormat::Bgr});
    const auto beyond = texelBytes(levels, Target::Texture2D, tapAt(12, 3));
    ASSERT_TRUE(beyond);
    EXPECT_TRUE(beyond->values.empty());
    EXPECT_EQ(sentenceOf(*beyond), "memory at byte 180–182: beyond its end, 0");
    const TextureLevels shifted = levelsOf({.format = TransferFormat::Rgba, .alignment = 1});
    EXPECT_EQ(texelBytes(shifted, Target::Texture2D, tapAt(0, 3))->range, (ByteRange{180, 4}));
    const TextureLevels partly = levelsOf({.format = TransferFormat::Rgba, .alignment = 1, .rowLength = 13});
    EXPECT_EQ(sentenceOf(*texelBytes(partly, Target::Texture2D, tapAt(5, 3))),
              "memory at byte 176–179: 176 177 178 179, r b g r, read as r g b a");
    const TextureLevels half = levelsOf(
        {.format = TransferFormat::Rgb, .type = TransferType::UnsignedShort, .alignment = 1, .rowLength = 8});
    EXPECT_EQ(sentenceOf(*texelBytes(half, Target::Texture2D, tapAt(6, 3))),
              "memory at byte 180–185: beyond its end, 0");
}

TEST(BytesOfTexels, CanBeBetweenRowsAndPacked) {
    Upload upload{.memory = MemoryRows::Layout, .memoryFormat = TransferFormat::Luminance};
    upload.memoryAlignment = 4;
    upload.format = TransferFormat::LuminanceAlpha;
    upload.alignment = 1;
    const TextureLevels padded = levelsOf(upload); // rows of 16 bytes, the last one padding
    EXPECT_EQ(texelBytes(padded, Target::Texture2D, tapAt(7, 0))->holds, "l-");
    upload = {.memory = MemoryRows::Layout, .memoryFormat = TransferFormat::Rgb};
    upload.memoryType = upload.type = TransferType::UnsignedShort565;
    upload.format = TransferFormat::Rgb;
    const auto packed = texelBytes(levelsOf(upload), Target::Texture2D, tapAt(1, 0));
    EXPECT_EQ(packed->holds, "p");
    EXPECT_THAT(std::string(sentenceOf(*packed)), testing::StartsWith("memory at byte 2–3: "));
    EXPECT_THAT(std::string(sentenceOf(*packed)), testing::Not(testing::HasSubstr("p,")));
}

TEST(LevelsOfTheDriver, HaveNoBytes) {
    const TextureLevels levels =
        levelsOf({.format = TransferFormat::Bgr, .alignment = 1}, MipPolicy::GenerateMipmap);
    EXPECT_TRUE(texelBytes(levels, Target::Texture2D, tapAt(0, 0)));
    EXPECT_FALSE(texelBytes(levels, Target::Texture2D, tapAt(0, 0, 1)));
    const TextureLevels own = levelsOf({.format = TransferFormat::Bgr, .alignment = 1}, MipPolicy::Generated);
    EXPECT_TRUE(texelBytes(own, Target::Texture2D, tapAt(0, 0, 1)));
}

TEST(TexelsOfTheBorderColour, HaveNoBytes) {
    Tap tap = tapAt(-1, 0);
    tap.border = true;
    EXPECT_FALSE(texelBytes(levelsOf({.format = TransferFormat::Bgr}), Target::Texture2D, tap));
}

} // namespace
} // namespace texplorer::reference::texel_bytes_test
