#include "tests/core/reference/textures.h"
#include "texplorer/reference/explain/tap_places.h"
#include "texplorer/reference/sampling/sampler.h"

#include <gmock/gmock.h>

namespace texplorer::reference::tap_places_test {
namespace {

using namespace test;

/// Four texels in a row, red 0, 0.1, 0.2, 0.3; one level.
SampledTexture rowOf4(Wrap wrap, MagFilter filter = MagFilter::Nearest) {
    SampledTexture texture;
    texture.levels.push_back(makeLevel({4, 4, 1}, [](int i, int j, int) {
        return glm::vec4(static_cast<float>(i) / 10, static_cast<float>(j) / 10, 0, 1);
    }));
    texture.minFilter = MinFilter::Linear;
    texture.magFilter = filter;
    texture.wrapS = texture.wrapT = texture.wrapR = wrap;
    texture.borderColor = {1, 1, 1, 1};
    return texture;
}

struct Case {
    const char* name;
    Wrap wrap;
    float s;
    int texel; ///< that is read
    int place; ///< its place, counted beyond the image
};
class TapPlaces : public testing::TestWithParam<Case> {};

TEST_P(TapPlaces, AreWhereTheSampleIs) {
    const auto& [name, wrap, s, texel, place] = GetParam();
    const SampledTexture texture = rowOf4(wrap);
    const glm::vec3 coords(s, 0.4F, 0);
    const std::vector<PlacedTap> taps = placeTaps(texture, explainSample(texture, coords, {}), coords, 0);
    ASSERT_EQ(taps.size(), 1U);
    EXPECT_EQ(taps[0].tap.index.x, texel);
    EXPECT_EQ(taps[0].at, glm::ivec2(place, 1));
}

INSTANTIATE_TEST_SUITE_P(All, TapPlaces,
                         testing::Values(Case{"Inside", Wrap::Repeat, 0.6F, 2, 2},
                                         Case{"NextCopy", Wrap::Repeat, 1.1F, 0, 4},
                                         Case{"CopyBefore", Wrap::Repeat, -0.1F, 3, -1},
                                         Case{"FarCopy", Wrap::Repeat, 10.3F, 1, 41},
                                         Case{"Mirrored", Wrap::MirroredRepeat, 1.1F, 3, 4},
                                         Case{"MirroredFarther", Wrap::MirroredRepeat, 1.9F, 0, 7},
                                         Case{"MirroredTwice", Wrap::MirroredRepeat, 2.1F, 0, 8},
                                         Case{"MirroredBefore", Wrap::MirroredRepeat, -0.4F, 1, -2},
                                         Case{"Clamped", Wrap::ClampToEdge, 3, 3, 3},
                                         Case{"Border", Wrap::ClampToBorder, 3, 4, 4},
                                         Case{"Huge", Wrap::Repeat, 1e20F, 0, 0}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Six faces of 4 x 4 texels: red is a tenth of the face, green of i, blue of j.
SampledTexture cubeOf4() {
    SampledTexture texture;
    texture.target = Target::CubeMap;
    texture.minFilter = MinFilter::Linear;
    for (int face = 0; face < 6; ++face)
        texture.levelToFill(0, face) = makeLevel({4, 4, 1}, [face](int i, int j, int) {
            return glm::vec4(static_cast<float>(face), static_cast<float>(i), static_cast<float>(j), 10) /
                   10.0F;
        });
    return texture;
}

// On the edge of +x and +z: the left column of +x is next to the right column of +z.
TEST(LevelPatches, OfASeamlessCubeMapGoOnOnTheNextFace) {
    const SampledTexture texture = cubeOf4();
    SampleOptions options;
    options.seamlessCubeMap = true;
    const glm::vec3 direction(1, 0, 1);
    const SampleRecord sample = explainSample(texture, direction, {}, options);
    const std::vector<LevelPatch> patches = levelPatches(texture, sample, direction);
    ASSERT_EQ(patches.size(), 1U);
    const LevelPatch& patch = patches[0];
    EXPECT_TRUE(patch.seamless);
    EXPECT_EQ(patch.layer, 0);
    std::vector<std::pair<int, int>> places; // of the faces +z and +x
    for (const PlacedTap& tap : patch.taps)
        places.emplace_back(tap.tap.index.z, tap.at.x);
    EXPECT_THAT(places, testing::UnorderedElementsAre(std::pair(4, -1), std::pair(4, -1), std::pair(0, 0),
                                                      std::pair(0, 0)));
    const auto colorAt = [&](int x, int y) {
        const glm::ivec2 in = glm::ivec2(x, y) - patch.low;
        return patch.colors.at(static_cast<std::size_t>(in.y * patch.size.x + in.x));
    };
    EXPECT_TRUE(isNear(colorAt(0, 1), {0, 0, 0.1F, 1}));
    EXPECT_TRUE(isNear(colorAt(-1, 1), {0.4F, 0.3F, 0.1F, 1}));
    EXPECT_TRUE(isNear(colorAt(-2, 2), {0.4F, 0.2F, 0.2F, 1}));
}

// Around a corner, three of the four places have a texel.
TEST(LevelPatches, HaveTheMeanOfThreeTexelsBeyondACorner) {
    const SampledTexture texture = cubeOf4();
    SampleOptions options;
    options.seamlessCubeMap = true;
    const glm::vec3 direction(1, 1, 1);
    const SampleRecord sample = explainSample(texture, direction, {}, options);
    const LevelPatch patch = levelPatches(texture, sample, direction).at(0);
    const glm::ivec2 in = glm::ivec2(-1, -1) - patch.low;
    EXPECT_TRUE(isNear(patch.colors.at(static_cast<std::size_t>(in.y * patch.size.x + in.x)),
                       {0.2F, 0.2F, 0.1F, 1})); // (0, 0) of +x, (3, 3) of +y, (3, 0) of +z
    for (const PlacedTap& tap : patch.taps)
        EXPECT_TRUE(tap.at == glm::ivec2(0, 0) || tap.at == glm::ivec2(-1, 0) || tap.at == glm::ivec2(0, -1));
}

// At the rim half of the sample is the border: the patch shows it next to the last texel.
TEST(LevelPatches, ShowTheBorderThatClampReadsUnderALinearFilter) {
    for (const MagFilter filter : {MagFilter::Linear, MagFilter::Nearest}) {
        const SampledTexture texture = rowOf4(Wrap::Clamp, filter);
        const glm::vec3 coords(1.1F, 0.4F, 0);
        const LevelPatch patch = levelPatches(texture, explainSample(texture, coords, {}), coords).at(0);
        const glm::ivec2 in = glm::ivec2(4, 1) - patch.low;
        const glm::vec4 beyond = patch.colors.at(static_cast<std::size_t>(in.y * patch.size.x + in.x));
        const glm::vec4 edge(0.3F, 0.1F, 0, 1);
        EXPECT_TRUE(isNear(beyond, filter == MagFilter::Linear ? texture.borderColor : edge));
        for (const PlacedTap& tap : patch.taps) {
            const glm::ivec2 place = tap.at - patch.low;
            const auto index = static_cast<std::size_t>(place.y * patch.size.x + place.x);
            EXPECT_TRUE(isNear(patch.colors.at(index), tap.tap.color)) << tap.at.x;
        }
    }
}

TEST(LevelPatches, HoldTheTexelsAndTheirSurroundings) {
    const SampledTexture texture = rowOf4(Wrap::Repeat, MagFilter::Linear);
    const glm::vec3 coords(1, 0.5F, 0); // between texel 3 and the next copy's texel 0
    const std::vector<LevelPatch> patches = levelPatches(texture, explainSample(texture, coords, {}), coords);
    ASSERT_EQ(patches.size(), 1U);
    const LevelPatch& patch = patches[0];
    EXPECT_EQ(patch.place, glm::vec2(4, 2));
    EXPECT_EQ(patch.extent, glm::ivec2(4, 4));
    EXPECT_EQ(patch.low, glm::ivec2(2, 0));
    EXPECT_EQ(patch.size, glm::ivec2(4, 4));
    ASSERT_EQ(patch.taps.size(), 4U);
    EXPECT_EQ(patch.taps[0].at, glm::ivec2(3, 1));
    EXPECT_EQ(patch.taps[1].at, glm::ivec2(4, 1));
    // Texel 5, 2 is texel 1, 2 of the next copy.
    EXPECT_EQ(patch.colors[2 * 4 + 3], glm::vec4(0.1F, 0.2F, 0, 1));
}

TEST(LevelPatches, ShowTheBorder) {
    const SampledTexture texture = rowOf4(Wrap::ClampToBorder, MagFilter::Linear);
    const glm::vec3 coords(1, 0.5F, 0);
    const std::vector<LevelPatch> patches = levelPatches(texture, explainSample(texture, coords, {}), coords);
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_EQ(patches[0].colors[2 * 4 + 3], texture.borderColor);
    EXPECT_EQ(patches[0].colors[2 * 4 + 0], glm::vec4(0.2F, 0.2F, 0, 1));
}

TEST(LevelPatches, StaySmall) {
    SampledTexture texture = leveledTexture(64);
    texture.minFilter = MinFilter::Nearest;
    texture.maxAnisotropy = 16;
    const Derivatives wide{{1, 0, 0}, {0, 1.0F / 64, 0}};
    const std::vector<LevelPatch> patches =
        levelPatches(texture, explainSample(texture, {0.5F, 0.5F, 0}, wide), {0.5F, 0.5F, 0});
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_LE(patches[0].size.x, maxPatch);
    EXPECT_EQ(patches[0].colors.size(),
              static_cast<std::size_t>(patches[0].size.x) * static_cast<std::size_t>(patches[0].size.y));
}

} // namespace
} // namespace texplorer::reference::tap_places_test
