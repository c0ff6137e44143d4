// Which pixels lines and points cover, worked out by hand from sections 3.3 and 3.4 of the OpenGL 2.1
// specification, and what is interpolated along them.
//
// The diamond around the centre of a pixel is what is less than half a pixel away from it, x and y added up.
// A line has the pixels whose diamonds it meets, but the one that it ends in. Both ends are thought of as
// moved by something tiny to the left and something much tinier down, so that no end lies on a diamond's
// side.

#include "texplorer/reference/raster/assembly.h"
#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/shading/pass_state.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::reference::line_test {
namespace {

using testing::ElementsAre;

using Pixels = std::set<std::pair<int, int>>;
using Rows = std::vector<std::string>; ///< from the top down

constexpr Viewport viewport{8, 4};

/// A vertex at a place of the window, whose lower left corner is (0, 0). Exact for eighths of a pixel.
ShadedVertex vertexAt(glm::vec2 window, float value = 0, float w = 1, Viewport size = viewport) {
    ShadedVertex vertex;
    vertex.clip = glm::vec4(window.x / static_cast<float>(size.width) * 2 - 1,
                            window.y / static_cast<float>(size.height) * 2 - 1, 0, 1) *
                  w;
    vertex.primary = glm::vec4(value);
    vertex.secondary = glm::vec3(value);
    vertex.texCoords[0] = {value, 2 * value, 0, 1};
    return vertex;
}

/// For tests of the size only: what each line or point draws.
struct Drawing {
    Pass pass;
    PassState state;
    Drawing() { state.pass = &pass; }
};

/// The number of fragments of each pixel, rows as in the picture.
Rows rowsOf(const std::vector<Triangle>& parts, Viewport size = viewport) {
    Rows rows(static_cast<std::size_t>(size.height), std::string(static_cast<std::size_t>(size.width), '.'));
    for (const Triangle& part : parts) {
        eachCoveredRow(part, {0, size.width - 1, 0, size.height - 1}, [&](int x, int y, int count) {
            for (int i = x; i < x + count; ++i) {
                char& pixel =
                    rows[static_cast<std::size_t>(size.height - 1 - y)][static_cast<std::size_t>(i)];
                pixel = pixel == '.' ? '#' : '2';
            }
        });
    }
    return rows;
}

std::vector<Triangle> lineBetween(glm::vec2 from, glm::vec2 to, float width, const Drawing& drawing = {}) {
    const auto line = setUpLine(vertexAt(from), vertexAt(to), width, drawing.state, viewport, true);
    return line ? std::vector{*line} : std::vector<Triangle>{};
}

// --- Which pixels

struct LineCase {
    const char* name;
    glm::vec2 from;
    glm::vec2 to;
    Rows expected;
    float width = 1;
};
class LinePixels : public testing::TestWithParam<LineCase> {};

TEST_P(LinePixels, AreThoseOfTheDiamonds) {
    const auto& [name, from, to, expected, width] = GetParam();
    EXPECT_EQ(rowsOf(lineBetween(from, to, width)), expected);
}

INSTANTIATE_TEST_SUITE_P(
    XMajor, LinePixels,
    testing::Values(
        // From centre to centre: the pixel that it begins in, not the one that it ends in.
        LineCase{"Right", {0.5F, 1.5F}, {4.5F, 1.5F}, {"........", "........", "####....", "........"}},
        LineCase{"Left", {4.5F, 1.5F}, {0.5F, 1.5F}, {"........", "........", ".####...", "........"}},
        // x = 1 and x = 3 are moved to the left: into pixels 0 and 2.
        LineCase{"RightFromASide", {1, 1.5F}, {3, 1.5F}, {"........", "........", "##......", "........"}},
        LineCase{"LeftFromASide", {3, 1.5F}, {1, 1.5F}, {"........", "........", ".##.....", "........"}},
        // Between two rows it is moved into the lower one, whose diamonds it crosses only near the x of their
        // centres: its ends, slightly to the left of such an x, are in no diamond.
        LineCase{"RightBetweenRows", {0.5F, 2}, {4.5F, 2}, {"........", "........", "####....", "........"}},
        LineCase{"LeftBetweenRows", {4.5F, 2}, {0.5F, 2}, {"........", "........", "####....", "........"}},
        // The end is in the diamond of pixel 2: 0.25 + 0.125 away.
        LineCase{"EndsInADiamond",
                 {0.5F, 1.5F},
                 {2.25F, 1.625F},
                 {"........", "........", "##......", "........"}},
        // 0.375 + 0.25 away, behind the diamond.
        LineCase{"EndsBehindADiamond",
                 {0.5F, 1.5F},
                 {2.875F, 1.75F},
                 {"........", "........", "###.....", "........"}},
        // 0.375 + 0.25 away, before it.
        LineCase{"EndsBeforeADiamond",
                 {0.5F, 1.5F},
                 {2.125F, 1.75F},
                 {"........", "........", "##......", "........"}},
        // 0.25 + 0.125 away from the centre of pixel 0, and beyond it.
        LineCase{"BeginsInADiamond",
                 {0.75F, 1.625F},
                 {3.5F, 1.5F},
                 {"........", "........", "###.....", "........"}},
        LineCase{"BeginsBehindADiamond",
                 {0.875F, 1.75F},
                 {3.5F, 1.5F},
                 {"........", "........", ".##.....", "........"}},
        // At x = 0.5, 1.5 …: y = 0.47, 0.84, 1.21, 1.59, 1.96, 2.33, 2.71. The end is 0.125 + 0.375 away from
        // the centre of pixel 7, 3, on its lower right side, and moved to the left: inside.
        LineCase{
            "Rising", {0.25F, 0.375F}, {7.625F, 3.125F}, {"........", ".....##.", "..###...", "##......"}},
        // Back from there pixel 7, 3 is left, and the end is in the diamond of pixel 0, 0.
        LineCase{"FallingToTheLeft",
                 {7.625F, 3.125F},
                 {0.25F, 0.375F},
                 {".......#", ".....##.", "..###...", ".#......"}}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    YMajor, LinePixels,
    testing::Values(
        LineCase{"Up", {2.5F, 0.5F}, {2.5F, 3.5F}, {"........", "..#.....", "..#.....", "..#....."}},
        LineCase{"Down", {2.5F, 3.5F}, {2.5F, 0.5F}, {"..#.....", "..#.....", "..#.....", "........"}},
        // x = 2 is moved into column 1, by more than y is moved: its ends are in the right corners of the
        // diamonds.
        LineCase{"UpBetweenColumns", {2, 0.5F}, {2, 3.5F}, {"........", ".#......", ".#......", ".#......"}},
        LineCase{
            "DownBetweenColumns", {2, 3.5F}, {2, 0.5F}, {".#......", ".#......", ".#......", "........"}},
        // At y = 3.5, 2.5 …: x = 1.38, 1.92, 2.46, 2.99. The end is 0.375 + 0.25 away from pixel 3, 0.
        LineCase{"DownToTheRight",
                 {1.25F, 3.75F},
                 {3.125F, 0.25F},
                 {".#......", ".#......", "..#.....", "..#....."}},
        LineCase{"UpToTheLeft",
                 {3.125F, 0.25F},
                 {1.25F, 3.75F},
                 {".#......", ".#......", "..#.....", "..#....."}}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Diagonal, LinePixels,
    testing::Values(
        LineCase{"UpRight", {0.5F, 0.5F}, {3.5F, 3.5F}, {"........", "..#.....", ".#......", "#......."}},
        LineCase{"DownLeft", {3.5F, 3.5F}, {0.5F, 0.5F}, {"...#....", "..#.....", ".#......", "........"}},
        // y = x + 0.5 runs along sides of diamonds: the lower right ones of pixels 0, 1 and 1, 2. Moved to
        // the left it is above them, and inside.
        LineCase{"UpAlongSides", {0.5F, 1}, {2.5F, 3}, {"........", ".#......", "#.......", "........"}},
        LineCase{"DownAlongSides", {2.5F, 3}, {0.5F, 1}, {"........", ".#......", "#.......", "........"}},
        // y = 3.5 - x is moved below the upper right ones of pixels 0, 2 and 1, 1.
        LineCase{
            "DownRightAlongSides", {0.5F, 3}, {2.5F, 1}, {"........", "#.......", ".#......", "........"}},
        LineCase{"UpLeftAlongSides", {2.5F, 1}, {0.5F, 3}, {"........", "#.......", ".#......", "........"}}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Short, LinePixels,
    testing::Values(LineCase{"NoLength", {1.5F, 1.5F}, {1.5F, 1.5F}, Rows(4, "........")},
                    LineCase{"WithinADiamond", {1.375F, 1.5F}, {1.625F, 1.5F}, Rows(4, "........")},
                    LineCase{"FromDiamondToDiamond",
                             {1.375F, 1.5F},
                             {2.125F, 1.5F},
                             {"........", "........", ".#......", "........"}},
                    // Around the corner of four pixels, where no diamond reaches.
                    LineCase{"BetweenDiamonds", {1.875F, 1.875F}, {2.125F, 2.125F}, Rows(4, "........")},
                    LineCase{"FromDiamondUpToDiamond",
                             {5.75F, 1.5F},
                             {5.75F, 2.5F},
                             {"........", "........", ".....#..", "........"}}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Wide, LinePixels,
    testing::Values(
        // Moved down by 1, and each pixel a column of three.
        LineCase{
            "ThreeRight", {0.5F, 1.5F}, {4.5F, 1.5F}, {"........", "####....", "####....", "####...."}, 3},
        LineCase{
            "ThreeLeft", {4.5F, 1.5F}, {0.5F, 1.5F}, {"........", ".####...", ".####...", ".####..."}, 3},
        LineCase{"ThreeUp", {2.5F, 0.5F}, {2.5F, 3.5F}, {"........", ".###....", ".###....", ".###...."}, 3},
        // Moved down by 0.5, between two rows: its ends are in no diamond, see above.
        LineCase{"TwoRight", {0.5F, 1.5F}, {4.5F, 1.5F}, {"........", "........", "####....", "####...."}, 2},
        LineCase{"TwoLeft", {4.5F, 1.5F}, {0.5F, 1.5F}, {"........", "........", "####....", "####...."}, 2},
        LineCase{"TwoUp", {2.5F, 0.5F}, {2.5F, 3.5F}, {"........", ".##.....", ".##.....", ".##....."}, 2},
        LineCase{"TwoDown", {2.5F, 3.5F}, {2.5F, 0.5F}, {".##.....", ".##.....", ".##.....", "........"}, 2},
        LineCase{"Four", {0.5F, 2}, {4.5F, 2}, Rows(4, "####...."), 4},
        // At x = 1.5, 2.5 …: y = 1.31, 1.53, 1.76, 1.99, 2.22. Moved by 1 it ends 0.25 away from the centre
        // of pixel 6, 1.
        LineCase{"ThreeRising",
                 {1.25F, 1.25F},
                 {6.75F, 2.5F},
                 {".....#..", ".#####..", ".#####..", ".####..."},
                 3},
        // Moved by 0.5 it ends 0.25 + 0.5 away from that of pixel 6, 1, and behind it.
        LineCase{
            "TwoRising", {1.25F, 1.25F}, {6.75F, 2.5F}, {"........", "..#####.", ".######.", ".#......"}, 2},
        LineCase{"FourUp", {2.25F, 0.625F}, {4, 3.375F}, {"........", ".####...", ".####...", "####...."}, 4},
        // Rounded, and never less than one.
        LineCase{
            "AboutThree", {0.5F, 1.5F}, {4.5F, 1.5F}, {"........", "####....", "####....", "####...."}, 2.6F},
        LineCase{
            "AThird", {0.5F, 1.5F}, {4.5F, 1.5F}, {"........", "........", "####....", "........"}, 0.3F}),
    [](const auto& test) { return std::string(test.param.name); });

// Each of these pixels belongs to one segment: the one that leaves its diamond, if two of them meet in it.
TEST(LineStrip, HitsEveryPixelOnce) {
    std::vector<Triangle> parts;
    Drawing drawing;
    const std::vector<glm::vec2> places{{0.5F, 0.5F}, {3.25F, 1.375F}, {5.625F, 2.75F}, {7.375F, 2.25F}};
    for (std::size_t i = 1; i < places.size(); ++i)
        for (const Triangle& part : lineBetween(places[i - 1], places[i], 1, drawing))
            parts.push_back(part);
    // At x = 0.5, 1.5 …: y = 0.5, 0.82, 1.14; 1.52, 2.10; 2.79, 2.5.
    EXPECT_THAT(rowsOf(parts), ElementsAre("........", "....###.", "..##....", "##......"));
    EXPECT_EQ(rowsOf(lineBetween(places[0], places[1], 1))[3], "##......");
    EXPECT_EQ(rowsOf(lineBetween(places[1], places[2], 1))[2], "...#....");
    EXPECT_EQ(rowsOf(lineBetween(places[2], places[3], 1))[1], ".....##.");
}

TEST(LineStrip, ThatRunsOnHasAPixelInEveryColumn) {
    std::mt19937 random(7);
    const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    for (int i = 0; i < 300; ++i) {
        std::vector<Triangle> parts;
        Drawing drawing;
        glm::vec2 from(static_cast<float>(below(64)) / 64, static_cast<float>(64 + below(129)) / 64);
        while (from.x < 7) {
            const int along = 1 + below(127);
            const int across = below(2 * along + 1) - along; // no steeper than a diagonal
            glm::vec2 to = from + glm::vec2(along, across) / 64.0F;
            to.y = std::clamp(to.y, 0.25F, 3.75F);
            for (const Triangle& part : lineBetween(from, to, 1, drawing))
                parts.push_back(part);
            from = to;
        }
        const Rows rows = rowsOf(parts);
        for (std::size_t x = 1; x < 7; ++x) {
            std::string column;
            for (const std::string& row : rows)
                column += row[x] == '.' ? "" : std::string(1, row[x]);
            EXPECT_EQ(column, "#") << "strip " << i << ", column " << x;
        }
    }
}

// --- All diamonds, tested one by one, in integers

/// In units of 2^-21 of a pixel, from the centre of pixel 0, 0. Places on a grid of 1/16 of a pixel are moved
/// by 2^-13 to the left and by 2^-21 down, which is little enough for lines as short as these.
struct Fine {
    std::int64_t x;
    std::int64_t y;
};
constexpr std::int64_t finePixel = std::int64_t{1} << 21;
constexpr std::int64_t fineSixteenth = finePixel / 16;

Fine fineOf(glm::ivec2 sixteenths) {
    return {sixteenths.x * fineSixteenth - 256, sixteenths.y * fineSixteenth - 1};
}

/// How far outside of the four sides of a diamond.
std::array<std::int64_t, 4> sidesAt(Fine place, int x, int y) {
    const std::int64_t dx = place.x - x * finePixel;
    const std::int64_t dy = place.y - y * finePixel;
    const std::int64_t half = finePixel / 2;
    return {dx + dy - half, dx - dy - half, dy - dx - half, -dx - dy - half};
}

/// Whether a line has the pixel: part of it is inside of the four sides, and its end isn't.
bool leavesDiamond(Fine from, Fine to, int x, int y) {
    const auto before = sidesAt(from, x, y);
    const auto after = sidesAt(to, x, y);
    // The share of the line that is inside, from one fraction to another.
    std::pair<std::int64_t, std::int64_t> first{0, 1};
    std::pair<std::int64_t, std::int64_t> last{1, 1};
    bool endsOutside = false;
    for (std::size_t side = 0; side < 4; ++side) {
        const std::int64_t a = before[side];
        const std::int64_t b = after[side];
        endsOutside = endsOutside || b >= 0;
        if (a >= 0 && b >= 0)
            return false;
        if (a < 0 && b < 0)
            continue;
        const std::pair crossing{std::abs(a), std::abs(a - b)};
        const auto isLess = [](const auto& one, const auto& other) {
            return one.first * other.second < other.first * one.second;
        };
        if (a >= 0 && isLess(first, crossing))
            first = crossing;
        else if (a < 0 && isLess(crossing, last))
            last = crossing;
    }
    return endsOutside && first.first * last.second < last.first * first.second;
}

Pixels pixelsOfDiamonds(glm::ivec2 from, glm::ivec2 to, int width) {
    const glm::ivec2 along = glm::abs(to - from);
    const bool xMajor = along.x >= along.y;
    const glm::ivec2 moved = (xMajor ? glm::ivec2(0, 8) : glm::ivec2(8, 0)) * (width - 1);
    Pixels pixels;
    for (int y = -8; y < 16; ++y) {
        for (int x = -8; x < 16; ++x) {
            if (!leavesDiamond(fineOf(from - moved), fineOf(to - moved), x, y))
                continue;
            for (int i = 0; i < width; ++i)
                pixels.insert(xMajor ? std::pair(x, y + i) : std::pair(x + i, y));
        }
    }
    return pixels;
}

TEST(Lines, HaveThePixelsWhoseDiamondsTheyLeave) {
    constexpr Viewport size{8, 8};
    constexpr Box all{0, 7, 0, 7};
    std::mt19937 random(3);
    const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    std::size_t covered = 0;
    for (int i = 0; i < 4000; ++i) {
        const int grid = std::array{1, 2, 4, 8}.at(static_cast<std::size_t>(below(4))); // ties, too
        const glm::ivec2 from(32 + below(64 / grid) * grid, 32 + below(64 / grid) * grid);
        const glm::ivec2 to(32 + below(64 / grid) * grid, 32 + below(64 / grid) * grid);
        const int width = std::max(1, below(7) - 1);
        const auto at = [&](glm::ivec2 sixteenths) { // which count from the centre of pixel 0, 0
            return vertexAt(glm::vec2(sixteenths) / 16.0F + 0.5F, 0, 1, size);
        };
        Drawing drawing;
        const auto line = setUpLine(at(from), at(to), static_cast<float>(width), drawing.state, size, true);
        Pixels found;
        if (line)
            eachCoveredRow(*line, all, [&](int x, int y, int count) {
                for (int c = 0; c < count; ++c)
                    EXPECT_TRUE(found.insert({x + c, y}).second);
            });
        Pixels expected = pixelsOfDiamonds(from, to, width);
        std::erase_if(expected, [](const auto& pixel) {
            return pixel.first < 0 || pixel.first > 7 || pixel.second < 0 || pixel.second > 7;
        });
        covered += expected.size();
        ASSERT_EQ(found, expected) << "line " << i << " from " << from.x << ", " << from.y << " to " << to.x
                                   << ", " << to.y << " in sixteenths, " << width << " wide";
    }
    EXPECT_GT(covered, 10'000U);
}

// --- Points

struct PointCase {
    const char* name;
    glm::vec2 at;
    float size;
    Rows expected;
};
class PointPixels : public testing::TestWithParam<PointCase> {};

TEST_P(PointPixels, AreASquare) {
    const auto& [name, at, size, expected] = GetParam();
    Drawing drawing;
    const auto point = setUpPoint(vertexAt(at), size, drawing.state, viewport, true);
    ASSERT_TRUE(point);
    EXPECT_EQ(rowsOf({*point}), expected);
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, PointPixels,
    testing::Values(
        // Odd: around the centre of the pixel that it is in, (floor(x) + 1/2, floor(y) + 1/2).
        PointCase{"One", {2.5F, 1.5F}, 1, {"........", "........", "..#.....", "........"}},
        PointCase{"OneOnACorner", {2, 1}, 1, {"........", "........", "..#.....", "........"}},
        PointCase{"OneAtTheEnd", {2.875F, 1.875F}, 1, {"........", "........", "..#.....", "........"}},
        PointCase{"Three", {2.375F, 1.625F}, 3, {"........", ".###....", ".###....", ".###...."}},
        // Even: around the nearest corner, (floor(x + 1/2), floor(y + 1/2)).
        PointCase{"TwoAtACentre", {2.5F, 1.5F}, 2, {"........", "..##....", "..##....", "........"}},
        PointCase{"TwoBelowACentre", {2.375F, 1.375F}, 2, {"........", "........", ".##.....", ".##....."}},
        PointCase{"Four", {3.625F, 1.625F}, 4, Rows(4, "..####..")},
        // Rounded, and never less than one.
        PointCase{"AboutThree", {2.5F, 1.5F}, 2.6F, {"........", ".###....", ".###....", ".###...."}},
        PointCase{"AboutTwo", {2.5F, 1.5F}, 2.4F, {"........", "..##....", "..##....", "........"}},
        PointCase{"Tiny", {2.5F, 1.5F}, 0.1F, {"........", "........", "..#.....", "........"}},
        PointCase{"AcrossTheRim", {0.5F, 0.5F}, 3, {"........", "........", "##......", "##......"}}),
    [](const auto& test) { return std::string(test.param.name); });

// --- Interpolated values

/// One texture unit that takes part, so that its coordinates are set up.
struct Textured : Drawing {
    SampledTexture texture;
    Textured() {
        state.unitsUsed = 1;
        state.units[0].texture = &texture;
        state.separateSpecular = true;
    }
};

constexpr Viewport wide{16, 16};

glm::vec2 offsetOf(const Triangle& line, int x, int y) {
    return glm::vec2(x, y) - line.origin;
}
template<class T>
T valueAt(const Plane<T>& plane, const Triangle& line, int x, int y) {
    return plane.at(offsetOf(line, x, y)) / line.invW.at(offsetOf(line, x, y));
}

// Equation 3.5: t = (p - a)(b - a) / |b - a|^2 at the centres of pixels, here an eighth for each of them.
TEST(LineValues, RunFromOneEndToTheOther) {
    Textured drawing;
    const std::vector<std::pair<glm::vec2, glm::vec2>> lines{
        {{0.5F, 1.5F}, {8.5F, 1.5F}}, {{0.5F, 0.5F}, {0.5F, 8.5F}}, {{0.5F, 0.5F}, {8.5F, 8.5F}}};
    for (const auto& [from, to] : lines) {
        const auto line = setUpLine(vertexAt(from, 0.25F, 1, wide), vertexAt(to, 0.75F, 1, wide), 1,
                                    drawing.state, wide, true);
        ASSERT_TRUE(line);
        EXPECT_FALSE(line->evenPrimary);
        for (int i = 0; i < 8; ++i) {
            const int x = to.x > 1 ? i : 0;
            const int y = to.y > 2 ? i : static_cast<int>(from.y);
            const float expected = 0.25F + static_cast<float>(i) / 16;
            EXPECT_NEAR(valueAt(line->primary, *line, x, y).r, expected, 1e-6F) << i;
            EXPECT_NEAR(valueAt(line->secondary, *line, x, y).r, expected, 1e-6F) << i;
            EXPECT_NEAR(valueAt(line->texCoords[0], *line, x, y).s, expected, 1e-6F) << i;
            EXPECT_NEAR(valueAt(line->texCoords[0], *line, x, y).t, 2 * expected, 1e-6F) << i;
            EXPECT_NEAR(valueAt(line->texCoords[0], *line, x, y).q, 1, 1e-6F) << i;
        }
    }
}

// Pixel 1, 1 of a line from pixel 0, 0 to 8, 4: (1, 1)(8, 4) / 80 = 0.15. A wide line has copies of one
// fragment there, all of them an eighth of the way along x.
TEST(LineValues, AreThoseOfThePlaceNextToThePixel) {
    Drawing drawing;
    for (const auto& [width, expected] : {std::pair{1.0F, 0.15F}, std::pair{3.0F, 0.125F}}) {
        const auto line = setUpLine(vertexAt({0.5F, 0.5F}, 0, 1, wide), vertexAt({8.5F, 4.5F}, 1, 1, wide),
                                    width, drawing.state, wide, true);
        ASSERT_TRUE(line);
        EXPECT_EQ(rowsOf({*line}, wide)[14][1], '#');
        EXPECT_NEAR(valueAt(line->primary, *line, 1, 1).r, expected, 1e-6F);
    }
}

// Equation 3.6: in the middle of the window, between w = 1 and w = 4,
// (0.5 * 0 / 1 + 0.5 * 1 / 4) / (0.5 / 1 + 0.5 / 4) = 0.125 / 0.625.
TEST(LineValues, AreThoseOfThePerspective) {
    Textured drawing;
    for (const bool perspective : {true, false}) {
        const auto line = setUpLine(vertexAt({0.5F, 1.5F}, 0, 1, wide), vertexAt({8.5F, 1.5F}, 1, 4, wide), 1,
                                    drawing.state, wide, perspective);
        ASSERT_TRUE(line);
        EXPECT_NEAR(valueAt(line->primary, *line, 4, 1).r, perspective ? 0.2F : 0.5F, 1e-6F);
        EXPECT_NEAR(valueAt(line->texCoords[0], *line, 4, 1).s, perspective ? 0.2F : 0.5F, 1e-6F);
    }
}

// Equation 3.7: depth is linear in the window, for any w.
TEST(LineValues, OfDepthAreLinear) {
    Drawing drawing;
    ShadedVertex near = vertexAt({0.5F, 1.5F}, 0, 1, wide);
    ShadedVertex far = vertexAt({8.5F, 1.5F}, 0, 4, wide);
    near.clip.z = -1; // the near plane: a depth of 0
    far.clip.z = 4;   // the far one: 1
    const auto line = setUpLine(near, far, 1, drawing.state, wide, true);
    ASSERT_TRUE(line);
    for (int x = 0; x < 8; ++x)
        EXPECT_NEAR(line->depth.at(offsetOf(*line, x, 1)), static_cast<float>(x) / 8, 1e-6F) << x;
}

TEST(LineValues, ThatBothEndsShareAreThemselves) {
    Drawing drawing;
    const auto line = setUpLine(vertexAt({0.5F, 1.5F}, 0.3F, 1, wide), vertexAt({8.5F, 5.5F}, 0.3F, 4, wide),
                                1, drawing.state, wide, true);
    ASSERT_TRUE(line && line->evenPrimary);
    EXPECT_EQ(*line->evenPrimary, glm::vec4(0.3F));
}

// Section 3.4.2: fragments are replicated, so that a column of them, or a row, has one value.
TEST(LineValues, OfAWideLineAreTheSameAcrossIt) {
    Drawing drawing;
    for (const glm::vec2 to : {glm::vec2(14.5F, 9.5F), glm::vec2(6.5F, 14.5F)}) {
        const bool xMajor = to.x > to.y;
        const auto line = setUpLine(vertexAt({2.5F, 4.5F}, 0, 1, wide), vertexAt(to, 1, 1, wide), 5,
                                    drawing.state, wide, true);
        ASSERT_TRUE(line);
        std::vector<std::set<float>> values(16); // of each column or row
        eachCoveredRow(*line, {0, 15, 0, 15}, [&](int x, int y, int count) {
            for (int i = x; i < x + count; ++i)
                values[static_cast<std::size_t>(xMajor ? i : y)].insert(
                    valueAt(line->primary, *line, i, y).r);
        });
        int filled = 0;
        for (const std::set<float>& each : values) {
            if (each.empty())
                continue;
            ++filled;
            EXPECT_NEAR(*each.begin(), *each.rbegin(), 1e-5F) << (xMajor ? "x-major" : "y-major");
        }
        EXPECT_GE(filled, 10);
    }
}

TEST(PointValues, AreThoseOfTheVertex) {
    Textured drawing;
    const auto point = setUpPoint(vertexAt({4.5F, 4.5F}, 0.5F, 2, wide), 5, drawing.state, wide, true);
    ASSERT_TRUE(point && point->evenPrimary);
    for (const int x : {2, 4, 6}) {
        EXPECT_EQ(valueAt(point->primary, *point, x, 3), glm::vec4(0.5F));
        EXPECT_EQ(valueAt(point->texCoords[0], *point, x, 3), glm::vec4(0.5F, 1, 0, 1));
        EXPECT_EQ(point->depth.at(offsetOf(*point, x, 3)), 0.5F);
    }
}

// --- From vertices to what is drawn

class Assembled : public testing::Test {
protected:
    std::vector<Triangle> assembled(const std::vector<ShadedVertex>& corners, Viewport size = wide) {
        std::vector<Triangle> made;
        const std::function<void(const Triangle&)> keep = [&](const Triangle& each) { made.push_back(each); };
        Assembly(drawing.state, model, size, keep).add(corners);
        return made;
    }
    Drawing drawing;
    Model model;
};

// Section 2.14.7, table 2.12: the colour of the second vertex.
TEST_F(Assembled, FlatLinesHaveTheLastColor) {
    drawing.state.flat = true;
    const auto made =
        assembled({vertexAt({0.5F, 1.5F}, 0.25F, 1, wide), vertexAt({8.5F, 1.5F}, 0.75F, 1, wide)});
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0].evenPrimary, glm::vec4(0.75F));
}

TEST_F(Assembled, HaveTheSizesOfTheirModel) {
    model.lineWidth = 3;
    model.pointSize = 2;
    EXPECT_THAT(rowsOf(assembled({vertexAt({0.5F, 1.5F}), vertexAt({4.5F, 1.5F})}, viewport), viewport),
                ElementsAre("........", "####....", "####....", "####...."));
    EXPECT_THAT(rowsOf(assembled({vertexAt({2.5F, 1.5F})}, viewport), viewport),
                ElementsAre("........", "..##....", "..##....", "........"));
}

// Clipped at x = 16: half of the way to the second vertex. Pixel 15 is 15/32 of the way; the end is outside
// of its diamond.
TEST_F(Assembled, LinesAreCutAtTheView) {
    const auto made = assembled({vertexAt({0.5F, 8.75F}, 0, 1, wide), vertexAt({32.5F, 8.75F}, 1, 1, wide)});
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(rowsOf(made, wide)[7], "################");
    EXPECT_NEAR(valueAt(made[0].primary, made[0], 15, 8).r, 15.0F / 32, 1e-5F);
    EXPECT_TRUE(assembled({vertexAt({17, 8.5F}, 0, 1, wide), vertexAt({32.5F, 9.5F}, 1, 1, wide)}).empty());
}

// From the middle of the view to a place behind the eye, to the right: z < -w there. The near plane cuts
// where w is 0, and before that the right one at x = w = 1/2.
TEST_F(Assembled, LinesThatGoBehindTheEyeAreCutBeforeIt) {
    ShadedVertex behind;
    behind.clip = {2, 0, 0, -1};
    const auto made = assembled({vertexAt({8, 8}, 0, 1, wide), behind});
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(rowsOf(made, wide)[8], "........########"); // y = 8 is moved into row 7
}

TEST_F(Assembled, LinesWithAnInfiniteEndAreLeftOut) {
    ShadedVertex odd;
    for (const float bad : {INFINITY, -INFINITY, NAN}) {
        odd.clip = {bad, 0, 0, 1};
        EXPECT_TRUE(assembled({vertexAt({8, 8}, 0, 1, wide), odd}).empty());
        EXPECT_TRUE(assembled({odd}).empty());
    }
}

// Section 2.12: a point is either drawn completely or not at all.
TEST_F(Assembled, PointsAreDrawnIfTheirVertexIsInTheView) {
    model.pointSize = 3;
    EXPECT_EQ(rowsOf(assembled({vertexAt({16, 8.5F}, 0, 1, wide)}), wide)[7], "...............#");
    EXPECT_TRUE(assembled({vertexAt({16.25F, 8.5F}, 0, 1, wide)}).empty());
    EXPECT_TRUE(assembled({vertexAt({-0.25F, 8.5F}, 0, 1, wide)}).empty());
    ShadedVertex vertex = vertexAt({8.5F, 8.5F}, 0, 1, wide);
    vertex.clip.z = 1.5F; // beyond the far plane
    EXPECT_TRUE(assembled({vertex}).empty());
    vertex.clip = -vertexAt({8.5F, 8.5F}, 0, 1, wide).clip; // behind the eye
    EXPECT_TRUE(assembled({vertex}).empty());
}

TEST(Parts, AreTheTrianglesLinesOrPointsOfAMesh) {
    Mesh mesh;
    std::vector<std::vector<std::uint32_t>> parts;
    const auto visit = [&] {
        parts.clear();
        eachPart(mesh, [&](std::span<const std::uint32_t> part, std::size_t number) {
            EXPECT_EQ(number, parts.size());
            parts.emplace_back(part.begin(), part.end());
        });
        return parts;
    };
    EXPECT_THAT(visit(), testing::IsEmpty());
    mesh.triangles = {0, 1, 2, 2, 1, 3};
    EXPECT_THAT(visit(), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(2, 1, 3)));
    mesh.triangles.clear();
    mesh.lines = {3, 1, 1, 2};
    EXPECT_THAT(visit(), ElementsAre(ElementsAre(3, 1), ElementsAre(1, 2)));
    mesh.lines.clear();
    mesh.points = {2, 0};
    EXPECT_THAT(visit(), ElementsAre(ElementsAre(2), ElementsAre(0)));
}

} // namespace
} // namespace texplorer::reference::line_test
