// Numbers by hand from OpenGL 2.1, section 3.6.4: equation 3.13, tables 2.9, 3.6 and 3.8 to 3.11.

#include "texplorer/upload/pixel_memory.h"

#include <gmock/gmock.h>

#include <bit>

namespace texplorer::pixel_memory_test {
namespace {

using testing::ElementsAre;

using Rgba = std::vector<int>;

Bytes bytes(std::initializer_list<int> values) {
    Bytes all;
    for (const int each : values)
        all.push_back(static_cast<std::byte>(each));
    return all;
}

Rgba pixelOf(const Image& image, int x, int y) {
    Rgba values;
    for (const std::byte each : image.at(x, y))
        values.push_back(std::to_integer<int>(each));
    return values;
}

/// What OpenGL makes of the bytes of one pixel.
Rgba read(std::initializer_list<int> memory, TransferFormat format, TransferType type, bool swaps = false) {
    UploadCall call{.layout = {format, type}};
    call.unpacking.swapBytes = swaps;
    return pixelOf(readPixels(bytes(memory), call, {1, 1, 1}), 0, 0);
}

TEST(RowStride, FollowsEquation313) {
    const auto stride = [](TransferFormat format, TransferType type, int width, int alignment,
                           int rowLength = 0) {
        return rowStride({{format, type}, {.alignment = alignment, .rowLength = rowLength}}, width);
    };
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedByte, 15, 4), 48U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedByte, 15, 1), 45U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedByte, 15, 8), 48U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedByte, 15, 4, 16), 48U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedByte, 15, 4, 17), 52U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::Float, 15, 4), 180U) << "a number has 4 bytes";
    EXPECT_EQ(stride(TransferFormat::Luminance, TransferType::UnsignedShort, 3, 4), 8U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedShort565, 3, 1), 6U);
    EXPECT_EQ(stride(TransferFormat::Rgb, TransferType::UnsignedByte, 15, 3), 48U)
        << "GL_INVALID_VALUE, and 4 stays";
}

TEST(PixelPlace, SkipsRowsAndPixels) {
    const UploadCall call{{TransferFormat::Bgr, TransferType::UnsignedByte},
                          {.alignment = 1, .rowLength = 10, .skipRows = 2, .skipPixels = 3}};
    const PixelExtent extent{4, 5, 2};
    EXPECT_EQ(bytesOf(call, extent, 0, 0), (ByteRange{69, 3})); // 2 rows of 30 bytes and 3 pixels of 3
    EXPECT_EQ(bytesOf(call, extent, 3, 1), (ByteRange{108, 3}));
    EXPECT_EQ(bytesOf(call, extent, 0, 0, 1), (ByteRange{219, 3})) << "a slice has 5 rows";
    EXPECT_EQ(bytesRead(call, extent), 351U); // 11 rows, and 7 pixels
    EXPECT_EQ(bytesRead(call, {0, 5, 1}), 0U);
}

TEST(Components, AreWhatTheFormatNames) {
    constexpr auto type = TransferType::UnsignedByte;
    EXPECT_THAT(read({1, 2, 3, 4}, TransferFormat::Rgba, type), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(read({1, 2, 3, 4}, TransferFormat::Bgra, type), ElementsAre(3, 2, 1, 4));
    EXPECT_THAT(read({1, 2, 3}, TransferFormat::Bgr, type), ElementsAre(3, 2, 1, 255));
    EXPECT_THAT(read({7}, TransferFormat::Luminance, type), ElementsAre(7, 7, 7, 255));
    EXPECT_THAT(read({7, 8}, TransferFormat::LuminanceAlpha, type), ElementsAre(7, 7, 7, 8));
    EXPECT_THAT(read({7}, TransferFormat::Alpha, type), ElementsAre(0, 0, 0, 7));
    EXPECT_THAT(read({7}, TransferFormat::Green, type), ElementsAre(0, 7, 0, 255));
}

TEST(Numbers, AreConvertedByTable29) {
    const auto grey = [](std::initializer_list<int> memory, TransferType type) {
        return read(memory, TransferFormat::Luminance, type)[0];
    };
    EXPECT_EQ(grey({127}, TransferType::Byte), 255);
    EXPECT_EQ(grey({0}, TransferType::Byte), 1);
    EXPECT_EQ(grey({0xFF}, TransferType::Byte), 0) << "-1 becomes -1/255";
    EXPECT_EQ(grey({0x80}, TransferType::Byte), 0);
    static_assert(std::endian::native == std::endian::little, "these bytes are of such a processor");
    EXPECT_EQ(grey({0x34, 0x12}, TransferType::UnsignedShort), 18); // 4660 / 65535 * 255 = 18.13
    EXPECT_EQ(grey({0x34, 0x12}, TransferType::Short), 36);
    EXPECT_EQ(grey({0, 0, 0, 0x80}, TransferType::UnsignedInt), 128);
    EXPECT_EQ(grey({0, 0, 0, 0x3F}, TransferType::Float), 128); // 0.5
    EXPECT_EQ(grey({0, 0, 0x80, 0xBF}, TransferType::Float), 0) << "-1";
    EXPECT_EQ(grey({0, 0, 0xC0, 0x7F}, TransferType::Float), 0) << "not a number";
}

TEST(PackedNumbers, HaveTheirFieldsInTheOrderOfTheirName) {
    constexpr auto rgb = TransferFormat::Rgb;
    constexpr auto rgba = TransferFormat::Rgba;
    EXPECT_THAT(read({0b101'010'01}, rgb, TransferType::UnsignedByte332), ElementsAre(182, 73, 85, 255));
    EXPECT_THAT(read({0b01'010'101}, rgb, TransferType::UnsignedByte233Rev), ElementsAre(182, 73, 85, 255));
    // 0xF81F: red and blue; 0x001F: the lowest five bits
    EXPECT_THAT(read({0x1F, 0x00}, rgb, TransferType::UnsignedShort565), ElementsAre(0, 0, 255, 255));
    EXPECT_THAT(read({0x1F, 0x00}, rgb, TransferType::UnsignedShort565Rev), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(read({0x21, 0x43}, rgba, TransferType::UnsignedShort4444), ElementsAre(68, 51, 34, 17));
    EXPECT_THAT(read({0x21, 0x43}, rgba, TransferType::UnsignedShort4444Rev), ElementsAre(17, 34, 51, 68));
    EXPECT_THAT(read({0x21, 0x43}, TransferFormat::Bgra, TransferType::UnsignedShort4444),
                ElementsAre(34, 51, 68, 17));
    EXPECT_THAT(read({0x01, 0xF8}, rgba, TransferType::UnsignedShort5551), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(read({0x1F, 0x80}, rgba, TransferType::UnsignedShort1555Rev), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(read({1, 2, 3, 4}, rgba, TransferType::UnsignedInt8888), ElementsAre(4, 3, 2, 1));
    EXPECT_THAT(read({1, 2, 3, 4}, rgba, TransferType::UnsignedInt8888Rev), ElementsAre(1, 2, 3, 4));
    // 1023 in the lowest ten bits, 3 in the highest two
    EXPECT_THAT(read({0xFF, 0x03, 0, 0xC0}, rgba, TransferType::UnsignedInt2101010Rev),
                ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(read({0x03, 0, 0xC0, 0xFF}, rgba, TransferType::UnsignedInt1010102),
                ElementsAre(255, 0, 0, 255));
}

TEST(SwappedBytes, AreThoseOfEachNumber) {
    EXPECT_EQ(read({0x12, 0x34}, TransferFormat::Luminance, TransferType::UnsignedShort, true)[0], 18);
    EXPECT_THAT(read({1, 2, 3, 4}, TransferFormat::Rgba, TransferType::UnsignedInt8888, true),
                ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(read({1, 2, 3, 4}, TransferFormat::Rgba, TransferType::UnsignedByte, true),
                ElementsAre(1, 2, 3, 4));
}

TEST(PixelTransfer, ScalesThenBiasesThenLimits) {
    UploadCall call{{TransferFormat::Luminance, TransferType::UnsignedByte}};
    call.scale = {2, 1, 0.5F, 0};
    call.bias = {-0.5F, 1, 0, 0.2F};
    EXPECT_THAT(pixelOf(readPixels(bytes({102}), call, {1, 1, 1}), 0, 0), ElementsAre(77, 255, 51, 51));
}

TEST(Memory, BeyondItsEndCountsAsZeros) {
    const UploadCall call{{TransferFormat::Rgb, TransferType::UnsignedByte}, {.alignment = 4}};
    // Two rows of one pixel: the program has 3 bytes a row, OpenGL takes 4.
    const Image image = readPixels(bytes({10, 20, 30, 40, 50, 60}), call, {1, 2, 1});
    EXPECT_THAT(pixelOf(image, 0, 0), ElementsAre(10, 20, 30, 255));
    EXPECT_THAT(pixelOf(image, 0, 1), ElementsAre(50, 60, 0, 255));
    EXPECT_EQ(bytesRead(call, {1, 2, 1}), 7U);
}

TEST(DepthComponents, BecomeDepths) {
    const UploadCall call{{TransferFormat::DepthComponent, TransferType::UnsignedShort}};
    const Image image = readPixels(bytes({0xFF, 0xFF}), call, {1, 1, 1});
    EXPECT_EQ(image.format, PixelFormat::Depth32);
    EXPECT_THAT(pixelOf(image, 0, 0), ElementsAre(255, 255, 255, 255));
}

TEST(Layouts, OfPackedTypesNeedTheirNumberOfComponents) {
    EXPECT_TRUE(checkLayout({TransferFormat::Bgra, TransferType::UnsignedInt8888Rev}));
    EXPECT_TRUE(checkLayout({TransferFormat::Rgb, TransferType::UnsignedShort565}));
    EXPECT_EQ(describe(checkLayout({TransferFormat::Rgba, TransferType::UnsignedShort565}).error()),
              "GL_INVALID_OPERATION: GL_UNSIGNED_SHORT_5_6_5 takes GL_RGB, not GL_RGBA");
    EXPECT_FALSE(checkLayout({TransferFormat::Bgr, TransferType::UnsignedShort565}));
    EXPECT_EQ(describe(checkLayout({TransferFormat::Luminance, TransferType::UnsignedShort4444}).error()),
              "GL_INVALID_OPERATION: GL_UNSIGNED_SHORT_4_4_4_4 takes GL_RGBA or GL_BGRA, not GL_LUMINANCE");
}

// Of every layout that holds all of a grey pixel's components: written and read it is what it was.
TEST(WrittenPixels, AreReadBackEqual) {
    Image image{PixelFormat::Rgb8, 3, 2, 1,
                bytes({0, 0, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255, 0, 0, 0, 0, 0, 0})};
    for (const TransferFormatFacts& format : transferFormatFacts) {
        for (const TransferTypeFacts& type : transferTypeFacts) {
            const PixelLayout layout{format.format, type.type};
            const bool holdsGrey = format.components.size() >= 3 || format.components.starts_with('l');
            if (!checkLayout(layout) || !holdsGrey)
                continue;
            for (const int alignment : {1, 2, 4, 8}) {
                const UploadCall call{layout, {.alignment = alignment}};
                const Bytes memory = writePixels(image, layout, alignment);
                const Image read = readPixels(memory, call, {3, 2, 1});
                EXPECT_LE(bytesRead(call, {3, 2, 1}), memory.size());
                for (int i = 0; i < 6; ++i) {
                    const int expected = std::to_integer<int>(image.at(i % 3, i / 3)[0]);
                    EXPECT_THAT(pixelOf(read, i % 3, i / 3), ElementsAre(expected, expected, expected, 255))
                        << rowOf(layout.format).name << ' ' << rowOf(layout.type).name << ' ' << alignment;
                }
            }
        }
    }
}

TEST(WrittenPixels, HaveRowsAtMultiplesOfTheAlignment) {
    const Image image{PixelFormat::Rgb8, 1, 2, 1, bytes({1, 2, 3, 4, 5, 6})};
    EXPECT_EQ(writePixels(image, {TransferFormat::Bgr, TransferType::UnsignedByte}, 4),
              bytes({3, 2, 1, 0, 6, 5, 4, 0}));
    EXPECT_EQ(writePixels(image, {TransferFormat::Rgb, TransferType::UnsignedByte}, 1),
              bytes({1, 2, 3, 4, 5, 6}));
}

} // namespace
} // namespace texplorer::pixel_memory_test
