// What Pillow sees in such files: tests/end_to_end/texshot/animate_test.py.

#include "texplorer/animation/apng.h"
#include "texplorer/animation/format.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_chunks.h"

#include <gmock/gmock.h>

namespace texplorer::animation::apng_test {
namespace {

using testing::ElementsAre;

Image plain(int width, int height, int value) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    std::ranges::fill(image.pixels, static_cast<std::byte>(value));
    return image;
}

TEST(Apng, HasItsChunksInTheOrderOfTheSpecification) {
    const auto encoder =
        apngEncoder({.width = 6, .height = 4, .plays = 3, .unitsPerSecond = 25, .texts = {{"Title", "x"}}});
    Image second = plain(6, 4, 10);
    second.at(2, 3)[0] = std::byte{99}; // row 3 is the upper one
    ASSERT_TRUE(encoder->add(plain(6, 4, 10), 1));
    ASSERT_TRUE(encoder->add(second, 2));
    ASSERT_TRUE(encoder->add(second, 3));
    const auto file = encoder->finish();
    ASSERT_TRUE(file);
    std::vector<std::string> types;
    std::vector<PngChunk> found;
    PngChunks chunks(*file);
    while (const auto chunk = chunks.next()) {
        types.push_back(chunk->type);
        found.push_back(*chunk);
    }
    EXPECT_THAT(types,
                ElementsAre("IHDR", "acTL", "tEXt", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT", "IEND"));
    EXPECT_EQ(bigEndian32(found[1].data, 0), 3U) << "pictures";
    EXPECT_EQ(bigEndian32(found[1].data, 4), 3U) << "plays";
    std::vector<std::uint32_t> sequence;
    for (const std::size_t i : {3U, 5U, 6U, 7U, 8U})
        sequence.push_back(bigEndian32(found[i].data, 0));
    EXPECT_THAT(sequence, ElementsAre(0, 1, 2, 3, 4));
    const auto rect = [&](std::size_t i) {
        return std::array{bigEndian32(found[i].data, 4), bigEndian32(found[i].data, 8),
                          bigEndian32(found[i].data, 12), bigEndian32(found[i].data, 16)};
    };
    EXPECT_THAT(rect(3), ElementsAre(6, 4, 0, 0));
    EXPECT_THAT(rect(5), ElementsAre(1, 1, 2, 0)) << "what has changed";
    EXPECT_THAT(rect(7), ElementsAre(1, 1, 0, 0)) << "nothing has";
    EXPECT_EQ(bigEndian32(found[5].data, 20), 2U << 16U | 25U) << "2 of 25 parts of a second";
    const auto first = decodePng(*file); // which also compares the checksums of what it reads
    ASSERT_TRUE(first);
    EXPECT_EQ(std::get<Image>(first->surfaces.front()).at(0, 0)[0], std::byte{10});
}

TEST(Format, IsKnownByTheEndOfAName) {
    EXPECT_EQ(formatOfName("a/b.GIF"), &rowOf(Format::Gif));
    EXPECT_EQ(formatOfName("b.webp"), &rowOf(Format::WebP));
    EXPECT_EQ(formatOfName("b.png"), &rowOf(Format::Apng));
    for (const char* name : {"", ".gif", "gif", "a.gif.bmp", "a.jpg", "-"})
        EXPECT_EQ(formatOfName(name), nullptr) << name;
}

} // namespace
} // namespace texplorer::animation::apng_test
