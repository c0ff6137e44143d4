// Where rounding decides, by hand: which texels, levels and faces are as right as those that were taken.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/explain/ties.h"
#include "texplorer/reference/sampling/sampler.h"

#include <gmock/gmock.h>

#include <optional>
#include <ostream>

namespace texplorer::reference::ties_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

/// One row of 8 texels, of which texel i is i / 10 in red, and its mip levels.
SampledTexture row(Wrap wrap) {
    SampledTexture texture;
    texture.target = Target::Texture1D;
    for (int size = 8; size >= 1; size /= 2)
        texture.levels.push_back(makeLevel(
            {size, 1, 1}, [](int i, int, int) { return glm::vec4(static_cast<float>(i) / 10, 0, 0, 1); }, 0,
            1));
    texture.wrapS = wrap;
    texture.minFilter = MinFilter::Nearest;
    texture.magFilter = MagFilter::Nearest;
    return texture;
}

/// At a lambda, one texel of the base level a pixel being 0.
Ties at(const SampledTexture& texture, glm::vec3 coords, float lambda) {
    const Derivatives change = texelsPerPixel(texture, std::exp2(lambda), 0);
    return tiesOf(texture, coords, change, {}, explainSample(texture, coords, change, {}));
}

struct Case {
    const char* name;
    Wrap wrap;
    float s;
    int chosen;
    std::optional<int> other; ///< nothing: it is no tie

    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};
class TexelTies : public testing::TestWithParam<Case> {};
TEST_P(TexelTies, AreBetweenTheTexelsOnBothSides) {
    const Case& c = GetParam();
    const SampledTexture texture = row(c.wrap);
    const SampleRecord sample = explainSample(texture, {c.s, 0, 0}, {}, {});
    ASSERT_EQ(sample.taps.size(), 1U);
    EXPECT_EQ(sample.taps[0].index.x, c.chosen);
    const Ties found = tiesOf(texture, {c.s, 0, 0}, {}, {}, sample);
    if (!c.other) {
        EXPECT_THAT(found.ties, IsEmpty());
        EXPECT_THAT(found.others, IsEmpty());
        return;
    }
    EXPECT_THAT(found.ties, ElementsAre(Tie{Tie::Between::Texels, c.chosen, *c.other, 0, 0}));
    ASSERT_EQ(found.others.size(), 1U);
    EXPECT_EQ(found.others[0].index.x, *c.other);
}

INSTANTIATE_TEST_SUITE_P(
    All, TexelTies,
    testing::Values(Case{"JustBelow", Wrap::Repeat, 0.49999875F, 3, 4}, // 3.99999 of 8
                    Case{"Exactly", Wrap::Repeat, 0.5F, 4, 3}, Case{"Between", Wrap::Repeat, 0.51F, 4, {}},
                    Case{"RepeatAtTheRim", Wrap::Repeat, 1, 0, 7},
                    Case{"RepeatFarAway", Wrap::Repeat, -2.5F, 4, 3},
                    Case{"MirroredAtTheRim", Wrap::MirroredRepeat, 1, 7, {}}, // the same texel on both sides
                    Case{"MirroredInside", Wrap::MirroredRepeat, 1.25F, 6, 5},
                    Case{"EdgeAtTheRim", Wrap::ClampToEdge, 1, 7, {}},
                    Case{"EdgeBeyond", Wrap::ClampToEdge, 1.5179F, 7, {}},
                    Case{"EdgeInside", Wrap::ClampToEdge, 0.5F, 4, 3},
                    Case{"ClampAtTheRim", Wrap::Clamp, 1, 7, {}}, Case{"ClampAtZero", Wrap::Clamp, 0, 0, {}},
                    Case{"BorderAtTheRim", Wrap::ClampToBorder, 1, 7, 8},
                    Case{"BorderAtZero", Wrap::ClampToBorder, 0, 0, -1}),
    [](const auto& test) { return test.param.name; });

// What is blended changes little by little.
TEST(Ties, AreNoneUnderALinearFilter) {
    SampledTexture texture = row(Wrap::Repeat);
    texture.minFilter = MinFilter::LinearMipmapLinear;
    texture.magFilter = MagFilter::Linear;
    for (const float lambda : {-1.0F, 0.0F, 0.5F, 1.0F, 1.5F})
        EXPECT_THAT(at(texture, {0.5F, 0, 0}, lambda).ties, IsEmpty()) << lambda;
}

TEST(Ties, AreHalfWayBetweenTwoLevels) {
    SampledTexture texture = row(Wrap::Repeat);
    texture.minFilter = MinFilter::NearestMipmapNearest;
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 0.5F).ties, ElementsAre(Tie{Tie::Between::Levels, 0, 1}));
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 1.49F).ties, ElementsAre(Tie{Tie::Between::Levels, 1, 2}));
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 1.51F).ties, ElementsAre(Tie{Tie::Between::Levels, 2, 1}));
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 1.4F).ties, IsEmpty());
    // 0.3 of 4 texels is 1.2, of 2 it is 0.6.
    const Ties found = at(texture, {0.3F, 0, 0}, 1.49F);
    ASSERT_EQ(found.others.size(), 1U);
    EXPECT_EQ(found.others[0].level, 2);
    EXPECT_EQ(found.others[0].index.x, 0);
    texture.maxLod = 1.5F; // what the scene has clamped is no rounding
    texture.minLod = 1.5F;
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 1.5F).ties, IsEmpty());
}

TEST(Ties, AreWhereOneFilterMeetsTheOther) {
    SampledTexture texture = row(Wrap::Repeat);
    texture.magFilter = MagFilter::Linear;
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 0).ties, ElementsAre(Tie{Tie::Between::Filters, 0, 0}));
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, -0.1F).ties, IsEmpty());
    texture.minFilter = MinFilter::Linear;
    EXPECT_THAT(at(texture, {0.3F, 0, 0}, 0).ties, IsEmpty());
}

TEST(Ties, AreOnTheEdgesOfACube) {
    SampledTexture texture;
    texture.target = Target::CubeMap;
    texture.minFilter = MinFilter::Nearest;
    texture.magFilter = MagFilter::Nearest;
    texture.levels = {makeLevel({4, 4, 1}, [](int, int, int) { return glm::vec4(1); })};
    texture.otherFaces.assign(5, texture.levels);
    const auto faces = [&](glm::vec3 direction) {
        std::vector<std::pair<int, int>> found;
        for (const Tie& tie :
             tiesOf(texture, direction, {}, {}, explainSample(texture, direction, {}, {})).ties)
            if (tie.between == Tie::Between::Faces)
                found.emplace_back(tie.chosen, tie.other);
        return found;
    };
    EXPECT_THAT(faces({1, 1, 0.1F}), ElementsAre(std::pair(0, 2)));
    EXPECT_THAT(faces({-3, 0.1F, 3.00001F}), ElementsAre(std::pair(4, 1)));
    EXPECT_THAT(faces({1, 0.9F, 0.1F}), IsEmpty());
}

} // namespace
} // namespace texplorer::reference::ties_test
