#include "app/ui/figures/upload_bytes.h"

#include <gtest/gtest.h>

namespace texplorer::ui::upload_bytes_test {
namespace {

using Kind = HeldByte::Kind;

constexpr PixelLayout rgb{TransferFormat::Rgb};
constexpr PixelLayout bgr{TransferFormat::Bgr};

/// Tight rows of 15 pixels of 3 bytes: 45 bytes, where an alignment of 4 expects 48.
const UploadBytes tight{{bgr, 1}, {rgb}, {15, 4}};

TEST(HeldBytes, AreComponentsThenPadding) {
    EXPECT_EQ(heldByte(tight, 0), (HeldByte{Kind::Component, 'b', 0, 0}));
    EXPECT_EQ(heldByte(tight, 47), (HeldByte{Kind::Component, 'r', 0, 1}));
    EXPECT_EQ(heldByte(tight, 180).kind, Kind::Beyond) << "4 rows of 45";
    const UploadBytes padded{{rgb, 4}, {rgb}, {15, 4}};
    EXPECT_EQ(heldByte(padded, 44), (HeldByte{Kind::Component, 'b', 14, 0}));
    EXPECT_EQ(heldByte(padded, 45).kind, Kind::Padding);
    EXPECT_EQ(heldByte(padded, 48), (HeldByte{Kind::Component, 'r', 0, 1}));
    const UploadBytes shorts{{{TransferFormat::Rgb, TransferType::UnsignedShort}, 1}, {rgb}, {2, 2}};
    EXPECT_EQ(heldByte(shorts, 3), (HeldByte{Kind::Component, 'g', 0, 0})) << "two bytes each";
    const UploadBytes packed{{{TransferFormat::Rgb, TransferType::UnsignedShort565}, 1}, {rgb}, {2, 2}};
    EXPECT_EQ(heldByte(packed, 3), (HeldByte{Kind::Packed, 0, 1, 0}));
}

TEST(Readers, AreTheTexelsWhoseBytesTheyAre) {
    EXPECT_EQ(readerOf(tight, 0), (TexelPlace{0, 0}));
    EXPECT_EQ(readerOf(tight, 44), (TexelPlace{14, 0}));
    EXPECT_EQ(readerOf(tight, 45), std::nullopt) << "OpenGL skips 3 bytes";
    EXPECT_EQ(readerOf(tight, 48), (TexelPlace{0, 1}));
    EXPECT_EQ(readerOf(tight, 188), (TexelPlace{14, 3}));
    EXPECT_EQ(readerOf(tight, 189), std::nullopt);
    UploadBytes skipping = tight;
    skipping.call.unpacking = {.skipRows = 1, .skipPixels = 2};
    EXPECT_EQ(readerOf(skipping, 48), std::nullopt);
    EXPECT_EQ(readerOf(skipping, 54), (TexelPlace{0, 0})) << "48 + 2 pixels of 3";
    UploadBytes overlapping = tight;
    overlapping.call.unpacking = {.alignment = 1, .rowLength = 5};
    EXPECT_EQ(readerOf(overlapping, 15), (TexelPlace{0, 1})) << "and the sixth texel of row 0";
    EXPECT_EQ(readerOf(overlapping, 89), (TexelPlace{14, 3})) << "3 rows of 15 bytes, and 15 pixels";
}

TEST(Verdicts, SayWhatIsWrong) {
    EXPECT_EQ(verdictOn(tight).english(),
              "Rows are 45 bytes in the memory, but OpenGL expects 48: the picture is slanted.");
    UploadBytes bytes = tight;
    bytes.call.unpacking.alignment = 1;
    EXPECT_EQ(verdictOn(bytes).english(), "The memory holds b g r; OpenGL reads r g b.");
    bytes.call.layout = bgr;
    EXPECT_EQ(verdictOn(bytes).english(), "The call fits the memory: rows are 45 bytes.");
    bytes.call.unpacking.skipRows = 1;
    EXPECT_EQ(verdictOn(bytes).english(), "OpenGL reads 225 bytes, the memory has 180.");
    bytes = {{{TransferFormat::Rgba}, 1}, {rgb}, {15, 4}};
    EXPECT_EQ(verdictOn(bytes).english(), "Pixels are 4 bytes in the memory, but OpenGL expects 3.");
    bytes = {{{TransferFormat::Luminance, TransferType::UnsignedInt}, 1},
             {{TransferFormat::Luminance, TransferType::Float}},
             {15, 4}};
    EXPECT_EQ(verdictOn(bytes).english(), "The memory holds l, Integer, from 0; OpenGL reads l, Float.");
}

TEST(Words, NameTheBytesOfATexelAndTheTexelOfAByte) {
    EXPECT_EQ(wordsOf(tight, TexelPlace{3, 2}).english(),
              "Texel (3, 2) = bytes 105 to 107 of the memory: b g r, read as r g b");
    EXPECT_EQ(wordsOf(tight, TexelPlace{0, 1}).english(),
              "Texel (0, 1) = bytes 48 to 50 of the memory: b g r, read as r g b");
    EXPECT_EQ(wordsOf(tight, TexelPlace{14, 3}).english(),
              "Texel (14, 3) = bytes 186 to 188 of the memory: - - -, read as r g b")
        << "beyond the end";
    EXPECT_EQ(wordsOf(tight, std::size_t{48}).english(), "Byte 48: b of pixel (1, 1); read by texel (0, 1)");
    EXPECT_EQ(wordsOf(tight, std::size_t{45}).english(), "Byte 45: b of pixel (0, 1); no texel reads it");
}

} // namespace
} // namespace texplorer::ui::upload_bytes_test
