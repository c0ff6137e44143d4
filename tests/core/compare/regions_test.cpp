#include "texplorer/compare/regions.h"

#include <gmock/gmock.h>

#include <random>
#include <string>

namespace texplorer::regions_test {
namespace {

using testing::ElementsAre;

PixelBits bitsOf(const std::vector<std::string>& rows) {
    PixelBits bits(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (std::size_t y = 0; y < rows.size(); ++y)
        for (std::size_t x = 0; x < rows[y].size(); ++x)
            if (rows[y][x] == '1')
                bits.set(static_cast<int>(x), static_cast<int>(y));
    return bits;
}

Regions regionsOf(const std::vector<std::string>& rows, std::size_t kept = 8) {
    return regionsIn(bitsOf(rows), {0, 0, static_cast<int>(rows[0].size()), static_cast<int>(rows.size())},
                     kept);
}

TEST(Regions, AreWhatTouchesAtASideOrACorner) {
    const Regions found = regionsOf({
        "1000110", //
        "0100110", //
        "0010000", //
        "0000000", //
        "1110001", //
    });
    EXPECT_EQ(found.count, 4U);
    EXPECT_THAT(found.largest,
                ElementsAre(DifferentRegion{{4, 0, 2, 2}, 4}, DifferentRegion{{0, 0, 3, 3}, 3},
                            DifferentRegion{{0, 4, 3, 1}, 3}, DifferentRegion{{6, 4, 1, 1}, 1}));
}

TEST(Regions, AreJoinedBelow) {
    const Regions found = regionsOf({
        "10101", //
        "10101", //
        "11111", //
    });
    EXPECT_THAT(found.largest, ElementsAre(DifferentRegion{{0, 0, 5, 3}, 11}));
    EXPECT_EQ(regionsOf({"101", "000", "101"}).count, 4U);
    EXPECT_EQ(regionsOf({"101", "010", "101"}).count, 1U);
}

TEST(Regions, GoOnAcrossWords) {
    std::string row(200, '0');
    row.replace(60, 80, std::string(80, '1'));
    std::string end(200, '0');
    end.back() = '1';
    const Regions found = regionsOf({row, end, std::string(200, '1')});
    EXPECT_THAT(found.largest,
                ElementsAre(DifferentRegion{{0, 1, 200, 2}, 201}, DifferentRegion{{60, 0, 80, 1}, 80}));
}

TEST(Regions, KeepTheLargest) {
    const Regions found = regionsOf({"1011011101111"}, 2);
    EXPECT_EQ(found.count, 4U);
    EXPECT_THAT(found.largest,
                ElementsAre(DifferentRegion{{9, 0, 4, 1}, 4}, DifferentRegion{{5, 0, 3, 1}, 3}));
}

/// The plain way: fill from every pixel.
std::size_t floodedRegions(std::vector<std::string> rows) {
    std::size_t count = 0;
    const int height = static_cast<int>(rows.size());
    const int width = static_cast<int>(rows[0].size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::vector<std::pair<int, int>> waiting{{x, y}};
            bool found = false;
            while (!waiting.empty()) {
                const auto [atX, atY] = waiting.back();
                waiting.pop_back();
                if (atX < 0 || atY < 0 || atX >= width || atY >= height)
                    continue;
                char& here = rows[static_cast<std::size_t>(atY)][static_cast<std::size_t>(atX)];
                if (here != '1')
                    continue;
                here = '0';
                found = true;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        waiting.emplace_back(atX + dx, atY + dy);
            }
            count += found ? 1 : 0;
        }
    return count;
}

TEST(Regions, AreAsManyAsFillingFinds) {
    std::minstd_rand dice(7);
    for (int round = 0; round < 60; ++round) {
        std::vector<std::string> rows(1 + dice() % 20, std::string(1 + dice() % 150, '0'));
        const auto share = 1 + dice() % 9;
        std::size_t set = 0;
        for (std::string& row : rows)
            for (char& each : row)
                if (dice() % 10 < share) {
                    each = '1';
                    ++set;
                }
        const Regions found = regionsOf(rows, 10000);
        EXPECT_EQ(found.count, floodedRegions(rows));
        std::size_t pixels = 0;
        for (const DifferentRegion& region : found.largest)
            pixels += region.pixels;
        EXPECT_EQ(pixels, set);
    }
}

} // namespace
} // namespace texplorer::regions_test
