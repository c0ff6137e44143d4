#include "tests/core/sheet/fixed_lettering.h"
#include "texplorer/sheet/layout.h"

#include <gmock/gmock.h>

#include <map>

namespace texplorer::sheet_layout_test {
namespace {

using sheet::Content;
using sheet::Layout;
using sheet::Line;
using sheet::TextRole;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Layout made(const Content& content) {
    const Result<Layout> layout = sheet::layoutOf(content, sheet_test::FixedLettering());
    EXPECT_TRUE(layout) << describe(layout.error());
    return layout.value_or(Layout());
}

// Letters are 8 wide; lines of titles 24 high, of headings 18, of labels 16, of notes 14. Margins are 24,
// gaps 12.

TEST(SheetLayout, OneAxisFillsRowsAboveItsLabels) {
    const Layout layout =
        made({.title = "cube", .cell = {40, 30}, .down = {"Wrap s", {"A", "BB", "CCC", "DDDD"}}});
    // Above the pictures: 24 margin, 24 title, 4, 18 the parameter, 16. A row: 30 picture, 6, 16 its label.
    EXPECT_EQ(layout.size, glm::ivec2(24 + 40 + 12 + 40 + 24, 86 + 52 + 12 + 52 + 24));
    EXPECT_THAT(layout.cells, ElementsAre(PixelRect{24, 86, 40, 30}, PixelRect{76, 86, 40, 30},
                                          PixelRect{24, 150, 40, 30}, PixelRect{76, 150, 40, 30}));
    EXPECT_THAT(layout.lines,
                ElementsAre(Line{24, 24, TextRole::Title, "cube"}, Line{24, 52, TextRole::Heading, "Wrap s"},
                            Line{40, 122, TextRole::Label, "A"}, Line{88, 122, TextRole::Label, "BB"},
                            Line{32, 186, TextRole::Label, "CCC"}, Line{80, 186, TextRole::Label, "DDDD"}));
    EXPECT_THAT(layout.notes, IsEmpty());
}

TEST(SheetLayout, SmallPicturesLeaveRoomForTheirLabels) {
    const Layout layout = made({.title = "s", .cell = {16, 16}, .down = {"w", {"GL_NEAREST", "GL_LINEAR"}}});
    // 80 pixels for ten letters, with the picture in their middle.
    EXPECT_THAT(layout.cells,
                ElementsAre(PixelRect{24 + 32, 86, 16, 16}, PixelRect{24 + 92 + 32, 86, 16, 16}));
    EXPECT_THAT(layout.lines, Contains(Line{24, 108, TextRole::Label, "GL_NEAREST"}));
    const Layout two =
        made({.title = "s", .cell = {16, 16}, .down = {"w", {"GL_NEAREST_MIPMAP_LINEAR", "b"}}});
    // At most 128, in two lines.
    EXPECT_THAT(two.lines, Contains(Line{24 + 20, 108, TextRole::Label, "GL_NEAREST_"}));
    EXPECT_THAT(two.lines, Contains(Line{24 + 12, 124, TextRole::Label, "MIPMAP_LINEAR"}));
    EXPECT_EQ(two.size, glm::ivec2(24 + 128 + 12 + 128 + 24, 86 + 16 + 6 + 32 + 24));
}

TEST(SheetLayout, ATableHasItsFirstAxisDown) {
    const Layout layout = made({.title = "s",
                                .caption = "abc",
                                .cell = {40, 30},
                                .down = {"Mode", {"ab", "abcdef"}},
                                .across = sheet::AxisLabels{"Filter", {"x", "y", "z"}},
                                .widestNote = "n"});
    // The corner takes six letters and a gap, 60. Above the pictures: 18 the title across, 6, 16 its
    // labels, 6.
    EXPECT_THAT(layout.cells, ElementsAre(PixelRect{84, 110, 40, 30}, PixelRect{136, 110, 40, 30},
                                          PixelRect{188, 110, 40, 30}, PixelRect{84, 169, 40, 30},
                                          PixelRect{136, 169, 40, 30}, PixelRect{188, 169, 40, 30}));
    EXPECT_EQ(layout.notes.front(), (PixelRect{84, 143, 40, 14}));
    EXPECT_EQ(layout.notes.size(), 6U);
    EXPECT_THAT(layout.lines,
                ElementsAre(Line{24, 24, TextRole::Title, "s"}, Line{132, 64, TextRole::Heading, "Filter"},
                            Line{40, 86, TextRole::Heading, "Mode"}, Line{100, 88, TextRole::Label, "x"},
                            Line{152, 88, TextRole::Label, "y"}, Line{204, 88, TextRole::Label, "z"},
                            Line{56, 117, TextRole::Label, "ab"}, Line{24, 176, TextRole::Label, "abcdef"},
                            Line{24, 228, TextRole::Note, "abc"}));
    EXPECT_EQ(layout.size, glm::ivec2(24 + 204 + 24, 228 + 14 + 24));
}

TEST(SheetLayout, NotesHaveTheirRoom) {
    const Layout layout =
        made({.title = "s", .cell = {16, 16}, .down = {"w", {"a"}}, .widestNote = "12 differ"});
    EXPECT_THAT(layout.cells, ElementsAre(PixelRect{24 + 28, 86, 16, 16}));
    EXPECT_THAT(layout.notes, ElementsAre(PixelRect{24, 86 + 16 + 6 + 16, 72, 14}));
}

TEST(SheetLayout, ALineThatSaysThePageStandsBelowTheTitle) {
    const Layout layout = made({.title = "s",
                                .subtitle = "Filter: x",
                                .cell = {400, 30},
                                .down = {"Mode", {"a"}},
                                .across = sheet::AxisLabels{"Wrap", {"b"}}});
    EXPECT_THAT(layout.lines, Contains(Line{24, 52, TextRole::Heading, "Filter: x"}));
}

TEST(SheetLayout, ALongTitleIsShortenedInTheMiddle) {
    const Layout layout =
        made({.title = std::string(50, 'a') + std::string(50, 'z'), .cell = {40, 30}, .down = {"w", {"b"}}});
    // 420 pixels for what stands above one picture, which stands in their middle.
    EXPECT_EQ(layout.lines.front().text, std::string(26, 'a') + "…" + std::string(25, 'z'));
    EXPECT_EQ(layout.size.x, 24 + 420 + 24);
    EXPECT_EQ(layout.cells.front().x, 24 + 190);
}

TEST(SheetLayout, NeighboursAreCloseToASquare) {
    const std::map<std::size_t, std::size_t> columns{{1, 1},  {2, 2},  {3, 3},  {4, 2},  {5, 3},
                                                     {6, 3},  {7, 4},  {8, 4},  {9, 3},  {10, 5},
                                                     {12, 4}, {13, 5}, {17, 6}, {36, 6}, {64, 8}};
    for (const auto& [count, expected] : columns)
        EXPECT_EQ(sheet::columnsFor(count), expected) << count;
}

TEST(SheetLayout, ASheetHasItsLargestExtent) {
    const auto of = [](glm::ivec2 cell, std::size_t count) {
        return sheet::layoutOf(
            {.title = "s", .cell = cell, .down = {"w", std::vector<std::string>(count, "a")}},
            sheet_test::FixedLettering());
    };
    EXPECT_TRUE(of({16384 - 48, 30}, 1));
    const auto wide = of({16384 - 47, 30}, 1);
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().code, ErrorCode::TooLarge);
    EXPECT_THAT(wide.error().message,
                HasSubstr("at most 16384 × 16384 pixels, this one would have 16385 × 162"));
    // The top has 86, the label with its gap 22, the bottom 24.
    EXPECT_TRUE(of({30, 16384 - 132}, 1));
    EXPECT_FALSE(of({30, 16384 - 131}, 1));
    EXPECT_FALSE(of({16384, 16384}, 4096)) << "beyond what an int can count";
}

} // namespace
} // namespace texplorer::sheet_layout_test
