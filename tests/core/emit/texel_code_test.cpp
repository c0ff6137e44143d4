#include "texplorer/emit/texel_code.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/texture/image_source.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace texplorer::emit_test {
namespace {

using emit::FileReader;
using emit::LevelCode;
using emit::TexelSource;
using testing::Each;
using testing::ElementsAre;
using testing::Field;

Bytes bytesOf(std::initializer_list<int> values) {
    Bytes bytes;
    for (const int value : values)
        bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

// Worked out by hand from the "Quite OK Image Format" (qoiformat.org): a run, a small and a larger
// difference, a whole colour, one that was seen before, an alpha.
TEST(PackedTexels, AreThoseOfTheFormat) {
    EXPECT_EQ(emit::packed(bytesOf({0, 0, 0, 255, 0, 0, 0, 255})), bytesOf({0xC1}));
    EXPECT_EQ(emit::packed(bytesOf({1, 255, 0, 255})), bytesOf({0x40 | 3 << 4 | 1 << 2 | 2}));
    EXPECT_EQ(emit::packed(bytesOf({10, 12, 8, 255})), bytesOf({0x80 | 44, 6 << 4 | 4}));
    EXPECT_EQ(emit::packed(bytesOf({100, 0, 0, 255})), bytesOf({0xFE, 100, 0, 0}));
    EXPECT_EQ(emit::packed(bytesOf({100, 0, 0, 255, 0, 200, 0, 255, 100, 0, 0, 255})),
              bytesOf({0xFE, 100, 0, 0, 0xFE, 0, 200, 0, (300 + 11 * 255) % 64}));
    EXPECT_EQ(emit::packed(bytesOf({0, 0, 0, 7})), bytesOf({0xFF, 0, 0, 0, 7}));
}

TEST(PackedTexels, BreakLongRuns) {
    Bytes same;
    for (int i = 0; i < 100; ++i)
        for (const int value : {0, 0, 0, 255})
            same.push_back(static_cast<std::byte>(value));
    EXPECT_EQ(emit::packed(same), bytesOf({0xC0 | 61, 0xC0 | 37}));
}

TEST(NumbersText, FillsRowsOfAHundredLetters) {
    EXPECT_EQ(emit::numbersText(bytesOf({1, 20, 255})), "    1, 20, 255,\n");
    EXPECT_EQ(emit::numbersText(bytesOf({1, 0, 0, 0, 255, 255, 255, 255}), emit::NumberType::UnsignedInt),
              "    0x1, 0xffffffff,\n");
    EXPECT_EQ(emit::numbersText({}), "");
    const std::string text = emit::numbersText(Bytes(100, std::byte{123}));
    EXPECT_EQ(text.find('\n'), 98U) << "four spaces and 19 numbers";
}

// The program reads the file, and leaves out the levels that are too large.
TEST(TexelCode, OfAFileThatIsTooLargeBeginsWithASmallerLevel) {
    TextureImage file;
    file.format = "DDS";
    file.levels = 3;
    for (const int extent : {16, 8, 4}) {
        BlockImage blocks = BlockImage::uninitialised(BlockFormat::Dxt1, extent, extent);
        std::ranges::fill(blocks.blocks, static_cast<std::byte>(extent));
        file.surfaces.emplace_back(std::move(blocks));
    }
    TexturePictures pictures(std::make_shared<const TextureImage>(std::move(file)));
    Texture texture;
    texture.source = SourceKind::File;
    texture.mipmaps = MipPolicy::FromFile;
    texture.flip = FlipMode::None;
    texture.oversize = Oversize::Smaller;
    for (const auto& [limit, first] : {std::pair{16, 0}, {15, 1}, {7, 2}}) {
        pictures.limits.size = limit;
        const auto code = emit::textureCode(texture, pictures, Target::Texture2D, FileReader::Dds);
        ASSERT_TRUE(code);
        EXPECT_EQ(code->reader, FileReader::Dds) << limit;
        EXPECT_EQ(code->firstLevel, first) << limit;
        EXPECT_EQ(code->levels.size(), 3U - static_cast<std::size_t>(first));
    }
}

std::vector<TexelSource> sourcesOf(const Texture& texture, Target target = Target::Texture2D) {
    const ImageSource images;
    const auto code = emit::textureCode(texture, images.picturesOf(texture), target);
    EXPECT_TRUE(code);
    std::vector<TexelSource> sources;
    for (const LevelCode& level : code->levels)
        sources.push_back(level.source);
    return sources;
}

TEST(TexelCode, IsWhatTakesTheFewestLines) {
    EXPECT_THAT(sourcesOf({.pattern = Pattern::Checker}), ElementsAre(TexelSource::Checker));
    EXPECT_THAT(sourcesOf({.pattern = Pattern::Gradient}), ElementsAre(TexelSource::Gradient));
    EXPECT_THAT(sourcesOf({.pattern = Pattern::Brick}), ElementsAre(TexelSource::Packed));
    EXPECT_THAT(sourcesOf({.pattern = Pattern::ColorLine}), ElementsAre(TexelSource::Listed));
    EXPECT_THAT(sourcesOf({.pattern = Pattern::MipColors}), ElementsAre(TexelSource::Flat));
    EXPECT_EQ(sourcesOf({.pattern = Pattern::MipColors, .mipmaps = MipPolicy::Colored}).back(),
              TexelSource::Listed)
        << "a texel alone";
    const std::vector<TexelSource> chain =
        sourcesOf({.pattern = Pattern::Checker, .mipmaps = MipPolicy::Generated});
    ASSERT_EQ(chain.size(), 7U);
    EXPECT_EQ(chain.front(), TexelSource::Checker);
    EXPECT_THAT(std::vector(chain.begin() + 1, chain.end()), Each(TexelSource::Halved));
    EXPECT_THAT(sourcesOf({.pattern = Pattern::Checker, .internalFormat = InternalFormat::DepthComponent16}),
                ElementsAre(TexelSource::Depths));
    EXPECT_THAT(sourcesOf({.pattern = Pattern::Brick, .compression = Compression::Cached}),
                ElementsAre(TexelSource::Compressed));
}

// Levels made with another filter are not averages of four texels.
TEST(TexelCode, HalvesOnlyWhatIsTheAverage) {
    const std::vector<TexelSource> chain = sourcesOf(
        {.pattern = Pattern::Brick, .mipmaps = MipPolicy::Generated, .mipFilter = MipFilter::Mitchell});
    EXPECT_THAT(std::vector(chain.begin(), chain.begin() + 4), Each(TexelSource::Packed));
}

// 64 x 64 texels have levels 0 to 6; one texel cannot be halved.
TEST(TexelCode, OfLevelsBeyondTheChainIsNoHalf) {
    Texture texture{.pattern = Pattern::Checker, .mipmaps = MipPolicy::Given};
    texture.levels.assign(8, GivenLevel{});
    texture.levels[6] = {.source = SourceKind::File, .file = "missing.png"}; // level 7
    const std::vector<TexelSource> sources = sourcesOf(texture);
    ASSERT_GE(sources.size(), 7U);
    EXPECT_NE(sources.back(), TexelSource::Halved);
}

// The first bytes, worked out by hand from the formats' descriptions.
TEST(FileReaders, ReadWhatTakesFewLines) {
    Bytes bmp(54, std::byte{0});
    const auto put = [](Bytes& bytes, std::size_t at, int value) {
        bytes.at(at) = static_cast<std::byte>(value);
    };
    put(bmp, 0, 'B');
    put(bmp, 1, 'M');
    put(bmp, 14, 40);
    put(bmp, 28, 24);
    EXPECT_EQ(emit::readerOf(bmp), FileReader::Bmp);
    put(bmp, 28, 8);
    EXPECT_EQ(emit::readerOf(bmp), FileReader::None) << "a palette";
    put(bmp, 28, 24);
    put(bmp, 30, 1);
    EXPECT_EQ(emit::readerOf(bmp), FileReader::None) << "runs";
    Bytes tga(18, std::byte{0});
    put(tga, 2, 2);
    put(tga, 16, 32);
    put(tga, 17, 0x28);
    EXPECT_EQ(emit::readerOf(tga), FileReader::Tga);
    put(tga, 2, 10);
    EXPECT_EQ(emit::readerOf(tga), FileReader::None) << "runs";
    Bytes dds(128, std::byte{0});
    for (std::size_t i = 0; i < 4; ++i) {
        put(dds, i, "DDS "[i]);
        put(dds, 84 + i, "DXT5"[i]);
    }
    EXPECT_EQ(emit::readerOf(dds), FileReader::Dds);
    put(dds, 87, '2');
    EXPECT_EQ(emit::readerOf(dds), FileReader::None);
    dds.resize(127);
    put(dds, 87, '5');
    EXPECT_EQ(emit::readerOf(dds), FileReader::None);
    EXPECT_EQ(emit::readerOf({}), FileReader::None);
}

} // namespace
} // namespace texplorer::emit_test
