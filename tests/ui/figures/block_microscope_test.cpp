// The block under the microscope, edited by synthetic clicks; what a block means stands in
// EXT_texture_compression_s3tc, and what is taken from a texture is held against its bytes.

#include "app/ui/model/explaining.h"
#include "tests/ui/figures/figure_bench.h"
#include "texplorer/s3tc/encode.h"

#include <cstring>

namespace texplorer::ui::block_microscope_test {
namespace {

using namespace test;

class BlockMicroscope : public FigureBench {
protected:
    BlockMicroscope()
        : FigureBench(Figure::Block) {}

    [[nodiscard]] BlockMicroscopeState& state() { return figures().block; }
    [[nodiscard]] BlockFields fields() { return fieldsOf(state().format, state().block); }
    [[nodiscard]] std::string hex() { return hexOf(state().format, state().block); }
};

TEST_F(BlockMicroscope, BeginsWithFourColours) {
    EXPECT_EQ(hex(), "20 FD 30 19 A0 E8 FA 7E");
    EXPECT_TRUE(has("block:mode"));
    EXPECT_TRUE(has("block:texel 15"));
    EXPECT_FALSE(has("block:bit 64"));
}

TEST_F(BlockMicroscope, AClickInThePaletteGivesTheChosenTexelItsIndex) {
    click("block:texel 6");
    EXPECT_EQ(state().texel, 6U);
    EXPECT_EQ(fields().indices[6], 2) << "choosing changes nothing";
    click("block:entry 1");
    EXPECT_EQ(fields().indices[6], 1);
    click("block:texel 6");
    EXPECT_EQ(fields().indices[6], 2) << "a second click takes the next index";
}

TEST_F(BlockMicroscope, AClickTurnsABitOver) {
    click("block:bit 63"); // the upper index bit of texel 15: from 01 to 11
    EXPECT_EQ(hex(), "20 FD 30 19 A0 E8 FA FE");
    EXPECT_EQ(fields().indices[15], 3);
    click("block:bit 15"); // red's highest of color 0: no longer the larger end
    EXPECT_FALSE(hasFourColors(state().format, fields()) && fields().colors[0] > 0x8000);
}

TEST_F(BlockMicroscope, SwappedEndsMakeAHole) {
    click("block:swap");
    EXPECT_EQ(hex(), "30 19 20 FD A0 E8 FA 7E");
    EXPECT_EQ(texelsOf(state().format, state().block)[7][3], 0) << "index 3";
    click("block:format DXT1 RGB");
    EXPECT_EQ(texelsOf(state().format, state().block)[7][3], 255) << "black, and opaque";
}

TEST_F(BlockMicroscope, TypedBytesAreTheBlockAsSoonAsTheyAreOne) {
    click("block:hex");
    key('A', {ctrl});
    type("00F81F00E40000");
    EXPECT_TRUE(has("block:hex problem"));
    EXPECT_EQ(hex(), "20 FD 30 19 A0 E8 FA 7E") << "not yet";
    type("40");
    EXPECT_FALSE(has("block:hex problem"));
    EXPECT_EQ(hex(), "00 F8 1F 00 E4 00 00 40");
}

TEST_F(BlockMicroscope, AnEndIsDraggedInItsOwnBits) {
    drag(place("block:color 1[2]"), {60, 0});
    EXPECT_GT(fields().colors[1] & 31, 0x1930 & 31);
    EXPECT_EQ(fields().colors[1] >> 5, 0x1930 >> 5) << "red and green stay";
}

TEST_F(BlockMicroscope, AlphasOfDxt5AreEightOrSix) {
    click("block:example Eight alphas");
    EXPECT_EQ(state().format, BlockFormat::Dxt5);
    EXPECT_TRUE(hasEightAlphas(fields()));
    EXPECT_TRUE(has("block:alpha entry 7"));
    EXPECT_FALSE(has("block:alpha entry 8"));
    click("block:swap alphas");
    EXPECT_FALSE(hasEightAlphas(fields()));
    click("block:texel 0");
    click("block:alpha entry 6");
    EXPECT_EQ(texelsOf(state().format, state().block)[0][3], 0);
    click("block:example 16 alphas");
    click("block:texel 3");
    click("block:alpha entry 15");
    EXPECT_EQ(fields().alphas[3], 15);
}

TEST_F(BlockMicroscope, WhatGoesTogetherLightsUp) {
    for (const auto& [name, mark] : {std::pair("block:texel 15", BlockMark{BlockMark::Kind::Texel, 15}),
                                     {"block:bit 3", {BlockMark::Kind::Field, 0}}, // of color 0
                                     {"block:entry 2", {BlockMark::Kind::Color, 2}}}) {
        moveTo(place(name));
        frames(2);
        EXPECT_EQ(state().hovered, mark);
    }
}

TEST_F(BlockMicroscope, PixelsOfTheTextureAreCompressedNow) {
    texture().pattern = Pattern::Checker;
    click("block:source texture");
    ASSERT_TRUE(state().source.original);
    EXPECT_FALSE(state().source.stored);
    EXPECT_TRUE(has("block:error"));
    click("block:right");
    click("block:up");
    EXPECT_EQ(state().source.x, 1);
    EXPECT_EQ(state().source.y, 1);
    const BlockBytes taken = state().block;
    click("block:bit 40");
    EXPECT_NE(state().block, taken);
    click("block:again");
    EXPECT_EQ(state().block, taken);
    // The same texels in a picture of their own, by the same encoder.
    Image image = Image::uninitialised(PixelFormat::Rgba8, 4, 4);
    std::memcpy(image.pixels.data(), state().source.original->data(), 64);
    const BlockImage expected = encodeBlocks(image, state().format, EncodeQuality::Best).value();
    EXPECT_TRUE(std::equal(expected.blocks.begin(), expected.blocks.end(), taken.begin()));
}

TEST_F(BlockMicroscope, ACompressedTextureGivesTheBytesThatItHas) {
    texture().compression = Compression::Cached;
    texture().compressedFormat = CompressedFormat::Dxt5;
    click("block:source texture");
    EXPECT_TRUE(has("block:stored"));
    EXPECT_EQ(state().format, BlockFormat::Dxt5);
    ASSERT_TRUE(state().source.original) << "what it was made of is known";
    const TextureLevels& levels = **state().source.levels;
    const auto& blocks = std::get<BlockImage>(*levels.levels.front().surface);
    EXPECT_TRUE(std::equal(state().block.begin(), state().block.end(), blocks.blocks.begin()));
    click("block:format DXT3");
    EXPECT_FALSE(has("block:stored")) << "another format is compressed now";
    EXPECT_EQ(state().format, BlockFormat::Dxt3);
}

TEST_F(BlockMicroscope, FollowsTheProbedPixel) {
    click("block:source probed");
    EXPECT_TRUE(has("block:problem")) << "no pixel is probed";
    session->look.explaining.pixel = {layout.picture.width / 4, layout.picture.height / 2};
    frames(3);
    const reference::UnitExplanation* unit = probedUnit(*session);
    ASSERT_NE(unit, nullptr);
    EXPECT_FALSE(has("block:problem"));
    const reference::Tap& tap = *std::ranges::max_element(unit->sample.taps, {}, &reference::Tap::weight);
    EXPECT_EQ(state().source.x, (tap.index.x << tap.level) / 4);
    EXPECT_EQ(state().source.y, (tap.index.y << tap.level) / 4);
}

// At the size that most windows have, nothing has to be scrolled to.
TEST_F(BlockMicroscope, AllOfItIsInSight) {
    for (const char* example : {"Four colours", "16 alphas", "Eight alphas"}) {
        click(fmt::format("block:example {}", example));
        frames(2);
        const int last = 8 * static_cast<int>(bytesPerBlock(state().format)) - 1;
        for (const std::string& name : {fmt::format("block:bit {}", last), std::string("block:texel 15"),
                                        std::string("block:example Six, 0 and 255")})
            EXPECT_TRUE(places.items.at(name).visible) << example << " " << name;
    }
}

TEST_F(BlockMicroscope, SaysWhyThereIsNoBlockToTake) {
    unit().texture = -1;
    click("block:source texture");
    frames(2);
    EXPECT_TRUE(has("block:problem"));
    click("block:source own");
    EXPECT_FALSE(has("block:problem"));
}

} // namespace
} // namespace texplorer::ui::block_microscope_test
