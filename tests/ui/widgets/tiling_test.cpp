// By the rules of OpenGL 2.1, section 3.8.7, for an image of 4 texels.

#include "app/ui/widgets/tiling.h"

#include <gtest/gtest.h>

namespace texplorer::ui {

static void PrintTo(const TileSpan& span, std::ostream* out) {
    *out << span.from << " to " << span.to;
}

} // namespace texplorer::ui

namespace texplorer::ui::tiling_test {
namespace {

struct Case {
    const char* name;
    Wrap wrap;
    int tile;
    std::optional<TileSpan> expected;
};

class Tiling : public testing::TestWithParam<Case> {};

TEST_P(Tiling, ShowsWhatTheWrapModeMakesOfTheSurroundings) {
    EXPECT_EQ(tileSpan(GetParam().wrap, GetParam().tile, 4), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Modes, Tiling,
                         testing::Values(Case{"RepeatLeft", Wrap::Repeat, -1, TileSpan{0, 1}},
                                         Case{"RepeatFarRight", Wrap::Repeat, 7, TileSpan{0, 1}},
                                         Case{"MirrorLeft", Wrap::MirroredRepeat, -1, TileSpan{1, 0}},
                                         Case{"MirrorRight", Wrap::MirroredRepeat, 1, TileSpan{1, 0}},
                                         Case{"MirrorSecondLeft", Wrap::MirroredRepeat, -2, TileSpan{0, 1}},
                                         Case{"EdgeLeft", Wrap::ClampToEdge, -1, TileSpan{0.125F, 0.125F}},
                                         Case{"EdgeRight", Wrap::ClampToEdge, 1, TileSpan{0.875F, 0.875F}},
                                         Case{"BorderLeft", Wrap::ClampToBorder, -1, std::nullopt},
                                         Case{"BorderInside", Wrap::ClampToBorder, 0, TileSpan{0, 1}},
                                         Case{"ClampRight", Wrap::Clamp, 1, TileSpan{0.875F, 0.875F}},
                                         Case{"MirrorInside", Wrap::MirroredRepeat, 0, TileSpan{0, 1}}),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace texplorer::ui::tiling_test
