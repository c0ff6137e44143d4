#include "tests/core/sheet/fixed_lettering.h"
#include "texplorer/sheet/sheet_picture.h"

#include <gmock/gmock.h>

namespace texplorer::sheet_picture_test {
namespace {

using sheet::Layout;
using sheet::SheetPicture;
using sheet::TextRole;
using Rgb = std::array<int, 3>;

/// Counted from the upper left.
Rgb at(const Image& picture, int x, int y) {
    const ByteView pixel = picture.at(x, picture.height - 1 - y);
    return {std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1]), std::to_integer<int>(pixel[2])};
}

/// Two places of 3 x 2 pixels, with a line for a note below each.
Layout twoCells() {
    return {.size = {60, 40},
            .lines = {{2, 1, TextRole::Title, "a"}},
            .cells = {{10, 20, 3, 2}, {40, 20, 3, 2}},
            .notes = {{5, 24, 16, 14}, {35, 24, 16, 14}}};
}

/// Pixels whose red counts them from the bottom left.
Image counted() {
    Image picture = Image::uninitialised(PixelFormat::Rgba8, 3, 2);
    for (int i = 0; i < 6; ++i) {
        const std::span<std::byte> pixel = picture.at(i % 3, i / 3);
        pixel[0] = std::byte(i);
        pixel[1] = std::byte{100};
        pixel[2] = std::byte{200};
        pixel[3] = std::byte{0}; // invisible
    }
    return picture;
}

constexpr Rgb ground{251, 251, 250};
constexpr Rgb frame{200, 200, 200};

TEST(SheetPicture, HasThePixelsOfItsPictures) {
    SheetPicture sheet(twoCells());
    sheet.put(1, counted());
    const Image image = std::move(sheet).take(sheet_test::FixedLettering());
    EXPECT_EQ(image.format, PixelFormat::Rgb8);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(at(image, 40 + i % 3, 21 - i / 3), (Rgb{i, 100, 200})) << i;
    EXPECT_EQ(at(image, 10, 20), ground) << "a place that nothing came for";
}

TEST(SheetPicture, FramesEachPictureOutside) {
    Layout layout = twoCells();
    layout.lines.clear();
    const Image image = SheetPicture(layout).take(sheet_test::FixedLettering());
    for (const auto& [x, y] : {std::pair{9, 19}, {13, 19}, {9, 22}, {13, 22}, {9, 20}, {11, 19}})
        EXPECT_EQ(at(image, x, y), frame) << x << ", " << y;
    for (const auto& [x, y] : {std::pair{8, 19}, {14, 19}, {10, 20}, {12, 21}, {59, 39}})
        EXPECT_EQ(at(image, x, y), ground) << x << ", " << y;
}

TEST(SheetPicture, WritesItsLinesAndItsNotes) {
    SheetPicture sheet(twoCells());
    sheet.note(0, "x");
    sheet.note(1, "much too long");
    const Image image = std::move(sheet).take(sheet_test::FixedLettering());
    EXPECT_EQ(at(image, 2, 1), (Rgb{27, 27, 30}));
    EXPECT_EQ(at(image, 8, 24), (Rgb{27, 27, 30})) << "the title's box ends at 10, 25";
    EXPECT_EQ(at(image, 9, 24), (Rgb{85, 85, 90})) << "one letter in the middle of 16 pixels";
    EXPECT_EQ(at(image, 8, 30), ground);
    EXPECT_EQ(at(image, 17, 30), ground);
    EXPECT_EQ(at(image, 35, 30), (Rgb{85, 85, 90})) << "m…";
    EXPECT_EQ(at(image, 50, 30), (Rgb{85, 85, 90}));
    EXPECT_EQ(at(image, 51, 30), ground);
}

TEST(SheetPicture, SaysInThePlaceWhyThereIsNone) {
    Layout layout = twoCells();
    layout.cells = {{10, 4, 40, 30}};
    layout.notes.clear();
    SheetPicture sheet(layout);
    sheet.refuse(0, "no");
    const Image image = std::move(sheet).take(sheet_test::FixedLettering());
    EXPECT_EQ(at(image, 10, 4), (Rgb{243, 234, 232}));
    EXPECT_EQ(at(image, 16, 10), (Rgb{140, 24, 20})) << "6 pixels from its edges";
    EXPECT_EQ(at(image, 31, 23), (Rgb{140, 24, 20}));
    EXPECT_EQ(at(image, 32, 10), (Rgb{243, 234, 232}));
    EXPECT_EQ(at(image, 49, 33), (Rgb{243, 234, 232}));
    EXPECT_EQ(at(image, 50, 33), frame);
}

} // namespace
} // namespace texplorer::sheet_picture_test
