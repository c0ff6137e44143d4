#include "texplorer/codec/dds/dds.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/saved_texture.h"

#include <gmock/gmock.h>

#include <initializer_list>
#include <numeric>

namespace texplorer::saved_texture_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Greys from the top row on, as read from a file that begins with the top row.
std::shared_ptr<const TextureImage> fileOf(int width, int height, std::initializer_list<int> greys) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height);
    std::ranges::transform(greys, image.pixels.begin(),
                           [](int grey) { return static_cast<std::byte>(grey); });
    flipVertically(image);
    return std::make_shared<const TextureImage>(textureOf(std::move(image), "PNG"));
}

std::shared_ptr<const TextureImage> colorFile(PixelFormat format, int width, int height,
                                              std::initializer_list<int> numbers) {
    Image image = Image::uninitialised(format, width, height);
    std::ranges::transform(numbers, image.pixels.begin(), [](int n) { return static_cast<std::byte>(n); });
    return std::make_shared<const TextureImage>(textureOf(std::move(image), "PNG"));
}

SavedTexture saved(const Texture& texture, const TexturePictures& pictures, const TextureSaving& how = {}) {
    Result<SavedTexture> made = savedTexture(texture, pictures, how);
    EXPECT_TRUE(made) << describe(made.error());
    return made ? *std::move(made) : SavedTexture{};
}

std::string refusalOf(const Texture& texture, const TexturePictures& pictures,
                      const TextureSaving& how = {}) {
    const Result<SavedTexture> made = savedTexture(texture, pictures, how);
    return made ? std::string() : made.error().message.english();
}

/// The bytes behind the header, 4 + 124 bytes, of which a DDS file consists.
std::vector<int> bytesBehindHeader(const SavedTexture& texture) {
    const Bytes file = encodeDds(texture.image).value();
    std::vector<int> bytes;
    for (std::size_t i = 128; i < file.size(); ++i)
        bytes.push_back(std::to_integer<int>(file[i]));
    return bytes;
}

struct FlipCase {
    const char* name;
    FlipMode flip;
    bool upsideDown; ///< in texture space
};

constexpr std::array flips{
    FlipCase{"Blocks", FlipMode::Blocks, false},
    FlipCase{"Pixels", FlipMode::Pixels, false},
    FlipCase{"Coordinates", FlipMode::Coordinates, false},
    FlipCase{"Matrix", FlipMode::Matrix, false},
    FlipCase{"None", FlipMode::None, true},
};

TEST(SavedTexture, HasTheRowAtTheTopThatIsAtTheTopOfTextureSpace) {
    for (const FlipCase& each : flips) {
        Texture texture;
        texture.flip = each.flip;
        const SavedTexture made = saved(texture, fileOf(1, 2, {10, 20}));
        EXPECT_EQ(bytesBehindHeader(made), each.upsideDown ? std::vector({20, 10}) : std::vector({10, 20}))
            << each.name;
        EXPECT_THAT(made.losses, IsEmpty());
        EXPECT_THAT(made.remarks, IsEmpty());
    }
}

TEST(SavedTexture, HasTheLevelsOfSeveralImages) {
    Texture texture;
    texture.mipmaps = MipPolicy::Given;
    texture.levels.resize(2, {.source = SourceKind::File});
    TexturePictures pictures(fileOf(4, 2, {1, 2, 3, 4, 5, 6, 7, 8}));
    pictures.levels = {fileOf(2, 1, {70, 80}), fileOf(1, 1, {90})};
    const SavedTexture made = saved(texture, pictures);
    EXPECT_EQ(made.image.levels, 3);
    EXPECT_THAT(bytesBehindHeader(made), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 70, 80, 90));

    pictures.levels.back() = colorFile(PixelFormat::Rgba8, 1, 1, {91, 92, 93, 94});
    EXPECT_THAT(bytesBehindHeader(saved(texture, pictures)),
                ElementsAre(1, 1, 1, 255, 2, 2, 2, 255, 3, 3, 3, 255, 4, 4, 4, 255, 5, 5, 5, 255, 6, 6, 6,
                            255, 7, 7, 7, 255, 8, 8, 8, 255, 70, 70, 70, 255, 80, 80, 80, 255, 93, 92, 91,
                            94))
        << "blue, green, red, alpha in all levels";

    pictures.levels.front() = fileOf(3, 1, {1, 2, 3});
    EXPECT_EQ(refusalOf(texture, pictures), "level 1 of a DDS file needs 2 × 1 texels, found 3 × 1");
    pictures.levels.front() = nullptr;
    EXPECT_EQ(refusalOf(texture, pictures), "a DDS file has all levels, but level 1 is missing");
    EXPECT_EQ(saved(texture, pictures, {.file = "PNG", .level = 2}).image.surfaces.size(), 1U);
    EXPECT_EQ(refusalOf(texture, pictures, {.file = "PNG", .level = 1}), "there is no level 1");
}

TEST(SavedTexture, HasOneLevelInAPicture) {
    Texture texture;
    texture.mipmaps = MipPolicy::Generated;
    const SavedTexture made = saved(texture, fileOf(2, 2, {0, 100, 200, 100}), {.file = "PNG", .level = 1});
    EXPECT_EQ(allLost(made.losses), "1 of the texture's 2 mip levels");
    const TextureImage read = decodePng(encodePng(made.image, {}).value()).value();
    EXPECT_THAT(std::get<Image>(read.surface(0, 0)).pixels, ElementsAre(std::byte{100}));
}

struct FormatCase {
    const char* name;
    InternalFormat format;
    PixelFormat stored;
    std::vector<int> bytes; ///< of red 10, green 20, blue 30, alpha 40
};

TEST(SavedTexture, HasTheComponentsOfItsInternalFormat) {
    const std::vector<FormatCase> cases{
        {"RGBA", InternalFormat::Rgba, PixelFormat::Rgba8, {10, 20, 30, 40}},
        {"RGB", InternalFormat::Rgb, PixelFormat::Rgb8, {10, 20, 30}},
        {"luminance is red", InternalFormat::Luminance, PixelFormat::Luminance8, {10}},
        {"luminance, alpha", InternalFormat::LuminanceAlpha, PixelFormat::LuminanceAlpha8, {10, 40}},
        {"intensity is red", InternalFormat::Intensity, PixelFormat::Luminance8, {10}},
        {"alpha", InternalFormat::Alpha, PixelFormat::Alpha8, {40}},
        // 10 · 31 / 255 = 1.2, 20: 2.4, 30: 3.6, so 1, 2 and 4, which are 8.2, 16.5 and 32.9 of 255
        {"RGB5", InternalFormat::Rgb5, PixelFormat::Rgb8, {8, 16, 33}},
    };
    for (const FormatCase& each : cases) {
        Texture texture;
        texture.internalFormat = each.format;
        const SavedTexture made = saved(texture, colorFile(PixelFormat::Rgba8, 1, 1, {10, 20, 30, 40}));
        const auto& image = std::get<Image>(made.image.surface(0, 0));
        EXPECT_EQ(image.format, each.stored) << each.name;
        std::vector<int> bytes;
        std::ranges::transform(image.pixels, std::back_inserter(bytes),
                               [](std::byte byte) { return std::to_integer<int>(byte); });
        EXPECT_EQ(bytes, each.bytes) << each.name;
        EXPECT_EQ(made.image.srgb, isSrgb(each.format)) << each.name;
    }
}

/// 8 x 8 texels in four blocks of different bytes, top row first.
std::shared_ptr<const TextureImage> blockFile(int height) {
    BlockImage blocks = BlockImage::uninitialised(BlockFormat::Dxt1, 8, height);
    for (std::size_t i = 0; i < blocks.blocks.size(); ++i) // red above blue: opaque
        blocks.blocks[i] = i % 8 == 1  ? std::byte{0xF8}
                           : i % 8 < 4 ? std::byte{0}
                                       : static_cast<std::byte>(29 * i);
    TextureImage texture;
    texture.format = "DDS";
    texture.topFirst = true;
    texture.surfaces.emplace_back(std::move(blocks));
    return std::make_shared<const TextureImage>(std::move(texture));
}

TEST(SavedTexture, KeepsTheBlocksOfAFile) {
    const auto file = blockFile(8);
    const Bytes& bytes = std::get<BlockImage>(file->surface(0, 0)).blocks;
    for (const FlipMode flip : {FlipMode::Blocks, FlipMode::Coordinates, FlipMode::Matrix}) {
        Texture texture;
        texture.flip = flip;
        const SavedTexture made = saved(texture, file);
        const TextureImage read = decodeDds(encodeDds(made.image).value()).value();
        EXPECT_EQ(std::get<BlockImage>(read.surface(0, 0)).blocks, bytes) << rowOf(flip).name;
        EXPECT_THAT(made.remarks, IsEmpty());
        EXPECT_TRUE(std::holds_alternative<Image>(
            saved(texture, file, {.blocks = SavedBlocks::None}).image.surface(0, 0)));
    }
}

TEST(SavedTexture, CompressesAgainWhatCantBeFlipped) {
    Texture texture;
    texture.flip = FlipMode::Blocks;
    texture.compression = Compression::Cached;
    const SavedTexture made = saved(texture, fileOf(1, 5, {250, 5, 5, 5, 5}));
    ASSERT_EQ(made.remarks.size(), 1U);
    EXPECT_THAT(made.remarks.front().english(), HasSubstr("compressed again"));
    const TextureImage read = decodeDds(encodeDds(made.image).value()).value();
    const Image image = toImage(read.surface(0, 0));
    EXPECT_GT(std::to_integer<int>(image.at(0, 0)[0]), 200) << "the top row of the file";
    EXPECT_LT(std::to_integer<int>(image.at(0, 1)[0]), 50);
}

TEST(SavedTexture, IsCompressedToTheChosenFormat) {
    Texture texture;
    texture.mipmaps = MipPolicy::Generated;
    const auto file = colorFile(PixelFormat::Rgba8, 2, 1, {9, 9, 9, 40, 200, 0, 0, 255});
    const TextureSaving how{.blocks = SavedBlocks::Chosen, .format = BlockFormat::Dxt1};
    const SavedTexture made = saved(texture, file, how);
    EXPECT_EQ(made.image.levels, 2);
    EXPECT_EQ(allLost(made.losses), "alpha (DXT1 keeps only red, green and blue)");
    EXPECT_EQ(std::get<BlockImage>(made.image.surface(0, 1)).format, BlockFormat::Dxt1);
    texture.compression = Compression::Driver;
    texture.compressedFormat = CompressedFormat::Dxt5;
    const SavedTexture byDriver = saved(texture, file);
    EXPECT_EQ(std::get<BlockImage>(byDriver.image.surface(0, 0)).format, BlockFormat::Dxt5);
    EXPECT_THAT(byDriver.remarks, ElementsAre(Sentence("The driver's own levels may differ a little.")));
    EXPECT_TRUE(TextureSaving{}.encodes(texture));
}

TEST(SavedTexture, IsWhatOpenGLReads) {
    // A program holds two rows of three texels of one byte, but GL_UNPACK_ALIGNMENT 4 expects the second row,
    // the upper one, one byte later.
    Texture texture;
    texture.flip = FlipMode::Pixels;
    texture.internalFormat = InternalFormat::Luminance;
    texture.upload = {.custom = true, .format = TransferFormat::Luminance, .alignment = 4};
    const SavedTexture made = saved(texture, fileOf(3, 2, {4, 5, 6, 1, 2, 3}));
    EXPECT_THAT(bytesBehindHeader(made), ElementsAre(5, 6, 0, 1, 2, 3));
    EXPECT_THAT(made.remarks,
                ElementsAre(Sentence("It is what OpenGL reads from the memory of the upload.")));
}

TEST(SavedTexture, LosesItsBorder) {
    Texture texture;
    texture.border = 1;
    const SavedTexture made = saved(texture, fileOf(4, 4, {0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0, 0, 0, 0, 0}));
    EXPECT_THAT(bytesBehindHeader(made), ElementsAre(0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0, 0, 0, 0, 0))
        << "its edges are repeated as the border";
    EXPECT_EQ(allLost(made.losses), "the border");
}

TEST(SavedTexture, IsACubeMapWithTheTopRowsFirst) {
    Texture texture;
    TextureImage cube = *fileOf(1, 2, {1, 2});
    cube.faces = 6;
    cube.topFirst = true;
    cube.surfaces.clear();
    for (int face = 0; face < 6; ++face) {
        Image image = Image::uninitialised(PixelFormat::Luminance8, 2, 2);
        std::iota(reinterpret_cast<unsigned char*>(image.pixels.data()),
                  reinterpret_cast<unsigned char*>(image.pixels.data()) + 4,
                  static_cast<unsigned char>(4 * face));
        cube.surfaces.emplace_back(std::move(image));
    }
    const auto file = std::make_shared<const TextureImage>(cube);
    const SavedTexture made = saved(texture, file, {.target = Target::CubeMap});
    EXPECT_EQ(made.image.faces, 6);
    std::vector<int> all(24);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(bytesBehindHeader(made), all);
    const SavedTexture one = saved(texture, file, {.file = "TGA", .target = Target::CubeMap});
    EXPECT_EQ(allLost(one.losses), "5 of the cube map's 6 faces");
}

TEST(SavedTexture, SaysWhyItCantBe) {
    Texture texture;
    texture.mipmaps = MipPolicy::Missing;
    const auto file = fileOf(4, 4, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16});
    EXPECT_THAT(refusalOf(texture, file), HasSubstr("is missing"));
    EXPECT_EQ(refusalOf(texture, {}), "the texture has no levels");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(savedTexture({}, file, {}, {.stop = stop.get_token()}).error().code, ErrorCode::Cancelled);
}

} // namespace
} // namespace texplorer::saved_texture_test
