// Pictures are the same bytes on every processor: compared with sums of what texshot drew on amd64, eight
// lanes at a time: `texshot shot --example NAME --renderer reference --size 160x120`, then zlib.crc32 over
// Pillow's RGB, the lowest row first.

#include "texplorer/lesson/example.h"
#include "texplorer/reference/draw.h"

#include <gtest/gtest.h>

#include <libdeflate.h>

namespace texplorer::reference::picture_sums_test {
namespace {

struct Case {
    const char* example;
    std::uint32_t sum;
};

void PrintTo(const Case& row, std::ostream* out) {
    *out << row.example;
}

class PictureSum : public testing::TestWithParam<Case> {};

TEST_P(PictureSum, IsThatOfAnotherProcessor) {
    const Result<Scene> scene = exampleScene(GetParam().example);
    ASSERT_TRUE(scene) << describe(scene.error());
    const Result<Frame> frame = drawReference({*scene, {}, 0, 160, 120});
    ASSERT_TRUE(frame) << describe(frame.error());
    Bytes colors; // without alpha, which the file doesn't have
    for (std::size_t i = 0; i < frame->image.pixels.size(); ++i) {
        if (i % 4 != 3)
            colors.push_back(frame->image.pixels[i]);
    }
    EXPECT_EQ(libdeflate_crc32(0, colors.data(), colors.size()), GetParam().sum);
}

INSTANTIATE_TEST_SUITE_P(
    Examples, PictureSum,
    testing::Values( //
        Case{"checker.json", 0x6FCFD750}, Case{"contours.json", 0xFF04FCCF}, Case{"cube.json", 0x012F075C},
        Case{"earth.json", 0xBDE21BA9}, Case{"environment.json", 0x300A914D},
        Case{"feedback.json", 0xCFC15B21}, Case{"floats.json", 0xDF7FEE22}, Case{"fog.json", 0xAACA5E9D},
        Case{"internal-formats.json", 0xEE1D2312}, Case{"levels.json", 0x86B191C4},
        Case{"line.json", 0xDF957115}, Case{"marble.json", 0x3057B412}, Case{"mirror.json", 0x3BDD3C08},
        Case{"nehe-bumps-1-unit.json", 0x2A65DABA}, Case{"nehe-bumps-2-units.json", 0x2CEEC917},
        Case{"nehe-no-bumps.json", 0x9EBB4281}, Case{"packed-pixels.json", 0x5995DEF2},
        Case{"quadrics.json", 0xE8FDACE8}, Case{"radial-blur.json", 0x0ADCF870},
        Case{"seamless.json", 0x223D57DC}, Case{"shadow-map.json", 0x9B756306},
        Case{"slide-projector.json", 0xEA988F27}, Case{"spiral.json", 0xE42D5222},
        Case{"teapot.json", 0x97ADBD49}, Case{"texbind.json", 0x1BE0A870}, Case{"texsub.json", 0x6E22C6EF}));

} // namespace
} // namespace texplorer::reference::picture_sums_test
