// Which texels of a row are mixed, worked out by hand from the OpenGL 2.1 specification, sections 3.8.7
// and 3.8.8.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/sampling/row_weights.h"
#include "texplorer/reference/sampling/sampler.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <string>

namespace texplorer::reference::row_weights_test {
namespace {

using testing::ElementsAre;

constexpr std::array wraps{Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge, Wrap::ClampToBorder,
                           Wrap::Clamp};

struct Case {
    const char* name;
    Wrap wrap;
    bool linear;
    float s;
    std::vector<RowTexel> taps; ///< of 4 texels
    float border;
};

class RowWeights : public testing::TestWithParam<Case> {};

TEST_P(RowWeights, AreThoseOfTheSpecification) {
    const Case& row = GetParam();
    const RowSample sample = sampleRow(row.wrap, row.linear, row.s, 4);
    EXPECT_EQ(sample.taps, row.taps);
    EXPECT_EQ(sample.border, row.border);
    EXPECT_EQ(sample.texels, row.s * 4);
}

using W = Wrap;
INSTANTIATE_TEST_SUITE_P(
    Edges, RowWeights,
    testing::Values(
        // u = 0, u - 1/2 = -0.5: half of texel -1, which is border.
        Case{"ClampAtZero", W::Clamp, true, 0, {{-1, 0.5F}, {0, 0.5F}}, 0.5F},
        Case{"ClampFarLeft", W::Clamp, true, -1, {{-1, 0.5F}, {0, 0.5F}}, 0.5F},
        // u = 4, u - 1/2 = 3.5: half of texel 4.
        Case{"ClampFarRight", W::Clamp, true, 2, {{3, 0.5F}, {4, 0.5F}}, 0.5F},
        // u = 0.25, u - 1/2 = -0.25: a quarter of the border.
        Case{"ClampInside", W::Clamp, true, 0.0625F, {{-1, 0.25F}, {0, 0.75F}}, 0.25F},
        Case{"ClampNearest", W::Clamp, false, -1, {{0, 1}}, 0},
        Case{"ClampNearestRight", W::Clamp, false, 2, {{3, 1}}, 0},
        // u = -0.5: all border.
        Case{"BorderFarLeft", W::ClampToBorder, true, -1, {{-1, 1}, {0, 0}}, 1},
        Case{"BorderAtZero", W::ClampToBorder, true, 0, {{-1, 0.5F}, {0, 0.5F}}, 0.5F},
        Case{"BorderNearest", W::ClampToBorder, false, -0.0625F, {{-1, 1}}, 1},
        // u = 0.5: all texel 0.
        Case{"EdgeFarLeft", W::ClampToEdge, true, -1, {{0, 1}, {1, 0}}, 0},
        Case{"EdgeAtZero", W::ClampToEdge, true, 0, {{0, 1}, {1, 0}}, 0},
        // u = 0: the last texel is the neighbour of the first.
        Case{"RepeatAtZero", W::Repeat, true, 0, {{3, 0.5F}, {0, 0.5F}}, 0},
        // u = 3.75: 0.25 beyond the centre of the last.
        Case{"RepeatBeforeZero", W::Repeat, true, -0.0625F, {{3, 0.75F}, {0, 0.25F}}, 0},
        Case{"RepeatNearest", W::Repeat, false, 1.25F, {{1, 1}}, 0},
        Case{"MirrorAtZero", W::MirroredRepeat, true, 0, {{0, 1}, {1, 0}}, 0},
        // 1.25 counts as 0.75, u = 3.
        Case{"MirrorBeyondOne", W::MirroredRepeat, true, 1.25F, {{2, 0.5F}, {3, 0.5F}}, 0},
        Case{"MirrorNearest", W::MirroredRepeat, false, 1.25F, {{3, 1}}, 0}),
    [](const auto& test) { return std::string(test.param.name); });

// The renderer's own sampler has the same weights, texel by texel.
TEST(RowWeights, AreThoseOfTheSampler) {
    for (const Wrap wrap : wraps) {
        for (const bool linear : {false, true}) {
            for (const int size : {2, 4, 8}) {
                SampledTexture texture;
                texture.target = Target::Texture1D;
                texture.levels = {test::makeLevel(
                    {size, 1, 1}, [](int, int, int) { return glm::vec4(0); }, 0, 1)};
                texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
                texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
                texture.wrapS = wrap;
                for (float s = -1; s <= 2; s += 0.01F) {
                    const RowSample row = sampleRow(wrap, linear, s, size);
                    const SampleRecord record = explainSample(texture, {s, 0, 0}, {});
                    ASSERT_EQ(row.taps.size(), record.taps.size());
                    for (std::size_t i = 0; i < row.taps.size(); ++i) {
                        EXPECT_EQ(row.taps[i].index, record.taps[i].index.x) << s;
                        EXPECT_EQ(row.taps[i].weight, record.taps[i].weight) << s;
                    }
                }
            }
        }
    }
}

TEST(RowPieces, OfClampUnderLinear) {
    // 2 texels: pieces of a quarter from -0.5 to 0.5.
    const std::vector<RowPiece> pieces = rowPieces(W::Clamp, true, -0.5F, 0.5F, 2);
    ASSERT_EQ(pieces.size(), 4U);
    using Share = RowPiece::Share;
    EXPECT_THAT(pieces[0].shares, ElementsAre(Share{-1, 0.5F, 0.5F}, Share{0, 0.5F, 0.5F}));
    EXPECT_THAT(pieces[1].shares, ElementsAre(Share{-1, 0.5F, 0.5F}, Share{0, 0.5F, 0.5F}));
    // from s = 0, half border, to the centre of texel 0 at s = 1/4
    EXPECT_THAT(pieces[2].shares, ElementsAre(Share{-1, 0.5F, 0}, Share{0, 0.5F, 1}));
    EXPECT_THAT(pieces[3].shares, ElementsAre(Share{0, 1, 0.5F}, Share{1, 0, 0.5F}));
}

TEST(RowPieces, AgreeWithTheSamplesBetweenTheirEnds) {
    for (const Wrap wrap : wraps) {
        for (const bool linear : {false, true}) {
            for (const int size : {2, 4, 8}) {
                for (const RowPiece& piece : rowPieces(wrap, linear, -1, 2, size)) {
                    for (const float share : {0.1F, 0.5F, 0.9F}) {
                        const RowSample sample =
                            sampleRow(wrap, linear, std::lerp(piece.from, piece.to, share), size);
                        float sum = 0;
                        for (const RowPiece::Share& each : piece.shares) {
                            const float weight = std::lerp(each.from, each.to, share);
                            float found = 0;
                            for (const RowTexel& tap : sample.taps)
                                found += tap.index == each.index ? tap.weight : 0;
                            EXPECT_NEAR(weight, found, 1e-5F);
                            sum += weight;
                        }
                        EXPECT_NEAR(sum, 1, 1e-5F);
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace texplorer::reference::row_weights_test
