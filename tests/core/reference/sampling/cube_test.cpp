// Cube maps: table 3.19 of OpenGL 2.1, worked out by hand.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/sampling/completeness.h"
#include "texplorer/reference/sampling/sampler.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace texplorer::reference::cube_test {
namespace {

using namespace test;

struct Hit {
    const char* name;
    glm::vec3 direction;
    int face;
    float s;
    float t;
};
class CubeDirection : public testing::TestWithParam<Hit> {};

// s = (sc / |ma| + 1) / 2, t = (tc / |ma| + 1) / 2
TEST_P(CubeDirection, HitsAFaceAtAPlace) {
    const CubePlace place = cubePlace(GetParam().direction, {});
    EXPECT_EQ(place.face, GetParam().face);
    EXPECT_FLOAT_EQ(place.coords.s, GetParam().s);
    EXPECT_FLOAT_EQ(place.coords.t, GetParam().t);
}

INSTANTIATE_TEST_SUITE_P(
    All, CubeDirection,
    testing::Values(Hit{"PositiveX", {2, 1, 0.5F}, 0, 0.375F, 0.25F},     // sc = -0.5, tc = -1, ma = 2
                    Hit{"NegativeX", {-2, 1, 0.5F}, 1, 0.625F, 0.25F},    // sc = 0.5, tc = -1
                    Hit{"PositiveY", {0.5F, 4, 2}, 2, 0.5625F, 0.75F},    // sc = 0.5, tc = 2
                    Hit{"NegativeY", {0.5F, -4, 2}, 3, 0.5625F, 0.25F},   // sc = 0.5, tc = -2
                    Hit{"PositiveZ", {1, 2, 4}, 4, 0.625F, 0.25F},        // sc = 1, tc = -2
                    Hit{"NegativeZ", {1, 2, -4}, 5, 0.375F, 0.25F},       // sc = -1, tc = -2
                    Hit{"Largest", {3e38F, 2e38F, 0}, 0, 0.5F, 1.0F / 6}, // tc = -2e38
                    Hit{"LargestCorner", {-3e38F, 3e38F, -3e38F}, 1, 0, 0},
                    Hit{"Least", {0, 0x1p-149F, 0}, 2, 0.5F, 0.5F}, Hit{"Zero", {0, 0, 0}, 0, 0.5F, 0.5F},
                    Hit{"NoNumber", {std::numeric_limits<float>::quiet_NaN(), 1, 0}, 0, 0.5F, 0.5F},
                    Hit{"Infinite", {0, std::numeric_limits<float>::infinity(), 0}, 0, 0.5F, 0.5F},
                    Hit{"Corner", {-1, 1, -1}, 1, 0, 0}),
    [](const auto& test) { return std::string(test.param.name); });

// The change over a small step, as a difference.
TEST(CubePlace, DerivativesAreThoseOfTheFace) {
    for (const glm::vec3 direction : {glm::vec3(2, 1, 0.5F), glm::vec3(-2, 0.3F, 1), glm::vec3(0.5F, 3, 1),
                                      glm::vec3(1, -3, 0.2F), glm::vec3(1, 1, 5), glm::vec3(1, -2, -5)}) {
        const glm::vec3 step{0.4F, -0.7F, 0.9F};
        const CubePlace place = cubePlace(direction, {step, -2.0F * step});
        constexpr float small = 1e-2F;
        const glm::vec3 difference = (cubePlace(direction + small * step, {}).coords -
                                      cubePlace(direction - small * step, {}).coords) /
                                     (2 * small);
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(place.derivatives.dx[axis], difference[axis], 2e-3F);
            EXPECT_NEAR(place.derivatives.dy[axis], -2 * difference[axis], 4e-3F);
        }
    }
}

// s = rx / rz of +z: s' = (rx' - s rz') / rz / 2, whose terms may be beyond what a float holds.
TEST(CubePlace, DerivativesOfFiniteDirectionsAreFinite) {
    EXPECT_FLOAT_EQ(cubePlace({0, 0, 3e38F}, {{3e38F, 0, -3e38F}, {}}).derivatives.dx.s, 0.5F);
    EXPECT_FLOAT_EQ(cubePlace({1.5e38F, 0, 3e38F}, {{3e38F, 0, -3e38F}, {}}).derivatives.dx.s, 0.75F);
    // 5e40, which no float is: the largest one stands for it, and the smallest level is read.
    SampledTexture texture = leveledTexture(8);
    texture.target = Target::CubeMap;
    texture.otherFaces.assign(5, texture.levels);
    texture.minFilter = MinFilter::LinearMipmapLinear;
    const SampleRecord record = explainSample(texture, {0, 0, 1e-3F}, {{1e38F, 0, 0}, {}});
    EXPECT_FALSE(record.lod.undefined);
    EXPECT_TRUE(isNear(record.color, {0.3F, 0, 0, 1}));
}

/// Face f is f / 10 in red; its texels i, j are told by green and blue.
SampledTexture cubeTexture(int extent) {
    SampledTexture texture;
    texture.target = Target::CubeMap;
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::Nearest;
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::ClampToEdge;
    for (int face = 0; face < 6; ++face)
        texture.levelToFill(0, face) = makeLevel({extent, extent, 1}, [face](int i, int j, int) {
            return glm::vec4(static_cast<float>(face), static_cast<float>(i), static_cast<float>(j), 10) /
                   10.0F;
        });
    return texture;
}

TEST(SampleOfACubeMap, ReadsTheFaceThatIsHit) {
    const SampledTexture texture = cubeTexture(4);
    const SampleRecord record = explainSample(texture, {1, 2, -4}, {}); // s = 0.375, t = 0.25 on -z
    EXPECT_TRUE(isNear(record.color, {0.5F, 0.1F, 0.1F, 1}));
    ASSERT_EQ(record.taps.size(), 1U);
    EXPECT_EQ(record.taps[0].index, glm::ivec3(1, 1, 5)); // of the face -z
    ASSERT_TRUE(record.cube);
    EXPECT_EQ(record.cube->face, 5);
    EXPECT_EQ(sample(texture, {1, 2, -4}, {}), record.color);
}

TEST(SampleOfACubeMap, KnowsTheShareOfATexelOfAFace) {
    const SampledTexture texture = cubeTexture(4);
    EXPECT_EQ(texelWeight(texture, {1, 2, -4}, {}, {}, {0, {1, 1, 5}}), 1);
    EXPECT_EQ(texelWeight(texture, {1, 2, -4}, {}, {}, {0, {1, 1, 4}}), 0);
}

// Half-way between the last texel and the first one of the same face; the neighbour is not asked.
TEST(SampleOfACubeMap, StaysOnItsFaceAtAnEdge) {
    SampledTexture texture = cubeTexture(4);
    texture.magFilter = MagFilter::Linear;
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::Repeat;
    EXPECT_TRUE(isNear(sample(texture, {0.999999F, 0, 1}, {}), {0.4F, 0.15F, 0.15F, 1}, 1e-4F));
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::ClampToEdge;
    EXPECT_TRUE(isNear(sample(texture, {0.999999F, 0, 1}, {}), {0.4F, 0.3F, 0.15F, 1}, 1e-4F));
}

// dx moves s of +z by 3 texels a pixel: (1/2 sc') * 16 = 3
TEST(SampleOfACubeMap, LambdaIsThatOfTheFace) {
    SampledTexture texture = cubeTexture(16);
    texture.minFilter = MinFilter::LinearMipmapLinear;
    const SampleRecord record = explainSample(texture, {0, 0, 1}, {{0.375F, 0, 0.2F}, {0, 0.125F, 0}});
    EXPECT_NEAR(record.lod.lengthX, 3, 1e-6);
    EXPECT_NEAR(record.lod.lengthY, 1, 1e-6);
}

// --- ARB_seamless_cube_map

/// An edge of a face of 4 x 4 texels: which face lies beyond it, and where its texels 1 and 3 go on.
struct Edge {
    const char* name;
    FaceTexel first;   ///< beyond the edge, at its texel 1
    FaceTexel second;  ///< at its texel 3
    FaceTexel beyond;  ///< what `first` is
    FaceTexel beyond2; ///< what `second` is
};
class CubeEdge : public testing::TestWithParam<Edge> {};

TEST_P(CubeEdge, GoesOnOnTheNextFace) {
    const Edge& edge = GetParam();
    for (const auto& [texel, beyond] :
         {std::pair{edge.first, edge.beyond}, std::pair{edge.second, edge.beyond2}}) {
        const std::optional<FaceTexel> found = foldedTexel(texel, 4);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->face, beyond.face);
        EXPECT_EQ(found->index, beyond.index);
        EXPECT_EQ(unfoldedTexel(*found, texel.face, 4), texel.index);
    }
}

// Table 3.19, with a texel's number i where its centre is at (i + 1/2) / 4. On +x s runs towards -z and t
// towards -y: its left edge (s = 0) is z = +1, which is the right edge (s = 1) of +z, whose t runs towards
// -y, too; its upper edge (t = 0) is y = +1, the right edge of +y, whose t runs towards +z: s = 0.375 of +x
// is t = 0.625 of +y. And so on.
INSTANTIATE_TEST_SUITE_P(
    All, CubeEdge,
    testing::Values(Edge{"LeftOfPositiveX", {0, {-1, 1}}, {0, {-1, 3}}, {4, {3, 1}}, {4, {3, 3}}},
                    Edge{"RightOfPositiveX", {0, {4, 1}}, {0, {4, 3}}, {5, {0, 1}}, {5, {0, 3}}},
                    Edge{"AbovePositiveX", {0, {1, -1}}, {0, {3, -1}}, {2, {3, 2}}, {2, {3, 0}}},
                    Edge{"BelowPositiveX", {0, {1, 4}}, {0, {3, 4}}, {3, {3, 1}}, {3, {3, 3}}},
                    Edge{"LeftOfNegativeX", {1, {-1, 1}}, {1, {-1, 3}}, {5, {3, 1}}, {5, {3, 3}}},
                    Edge{"RightOfNegativeX", {1, {4, 1}}, {1, {4, 3}}, {4, {0, 1}}, {4, {0, 3}}},
                    Edge{"AboveNegativeX", {1, {1, -1}}, {1, {3, -1}}, {2, {0, 1}}, {2, {0, 3}}},
                    Edge{"BelowNegativeX", {1, {1, 4}}, {1, {3, 4}}, {3, {0, 2}}, {3, {0, 0}}},
                    Edge{"AbovePositiveY", {2, {1, -1}}, {2, {3, -1}}, {5, {2, 0}}, {5, {0, 0}}},
                    Edge{"BelowPositiveY", {2, {1, 4}}, {2, {3, 4}}, {4, {1, 0}}, {4, {3, 0}}},
                    Edge{"AboveNegativeY", {3, {1, -1}}, {3, {3, -1}}, {4, {1, 3}}, {4, {3, 3}}},
                    Edge{"BelowNegativeY", {3, {1, 4}}, {3, {3, 4}}, {5, {2, 3}}, {5, {0, 3}}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FoldedTexel, StaysWhereItIsOnItsFaceAndIsNoneBeyondACorner) {
    EXPECT_EQ(foldedTexel({2, {0, 3}}, 4), (FaceTexel{2, {0, 3}}));
    for (const glm::ivec2 corner :
         {glm::ivec2(-1, -1), glm::ivec2(4, -1), glm::ivec2(-1, 4), glm::ivec2(4, 4)})
        EXPECT_FALSE(foldedTexel({2, corner}, 4));
    EXPECT_EQ(foldedTexel({4, {0, -1}}, 1), (FaceTexel{2, {0, 0}}));
    EXPECT_FALSE(unfoldedTexel({1, {0, 0}}, 0, 4)) << "the opposite face";
}

// Folding back and forth over every edge, at every distance, at sizes that no float tells texels of apart.
TEST(FoldedTexel, IsUnfoldedToWhereItWas) {
    for (const int size : {1, 2, 3, 5, 16384}) {
        for (int face = 0; face < 6; ++face) {
            for (const int along : {0, size / 2, size - 1}) {
                for (const glm::ivec2 index :
                     {glm::ivec2(-1, along), glm::ivec2(-size, along), glm::ivec2(size, along),
                      glm::ivec2(2 * size - 1, along), glm::ivec2(along, -1), glm::ivec2(along, size),
                      glm::ivec2(along, -size), glm::ivec2(along, 2 * size - 1)}) {
                    const std::optional<FaceTexel> texel = foldedTexel({face, index}, size);
                    ASSERT_TRUE(texel);
                    EXPECT_NE(texel->face, face);
                    EXPECT_GE(std::min(texel->index.x, texel->index.y), 0);
                    EXPECT_LT(std::max(texel->index.x, texel->index.y), size);
                    EXPECT_EQ(unfoldedTexel(*texel, face, size), index);
                }
            }
        }
    }
}

SampleOptions seamless() {
    SampleOptions options;
    options.seamlessCubeMap = true;
    return options;
}

// On the edge between +z and +x, half-way down: the four texels around it, two of each face.
TEST(SampleOfASeamlessCubeMap, BlendsBothSidesOfAnEdge) {
    SampledTexture texture = cubeTexture(4);
    texture.magFilter = MagFilter::Linear;
    texture.wrapS = texture.wrapT = Wrap::Repeat; // which counts no more
    // +z: texels (3, 1) and (3, 2), red 0.4; +x: (0, 1) and (0, 2), red 0. Green is i / 10, blue j / 10.
    const SampleRecord record = explainSample(texture, {1, 0, 1}, {}, seamless());
    EXPECT_TRUE(isNear(record.color, {0.2F, 0.15F, 0.15F, 1}));
    EXPECT_TRUE(record.seamless);
    ASSERT_EQ(record.taps.size(), 4U);
    for (const glm::ivec3 index :
         {glm::ivec3(3, 1, 4), glm::ivec3(3, 2, 4), glm::ivec3(0, 1, 0), glm::ivec3(0, 2, 0)}) {
        EXPECT_FLOAT_EQ(texelWeight(texture, {1, 0, 1}, {}, seamless(), {0, index}), 0.25F);
        EXPECT_TRUE(std::ranges::any_of(record.taps, [&](const Tap& tap) { return tap.index == index; }));
    }
    // The same from either side, to the last bits of the direction.
    EXPECT_TRUE(isNear(sample(texture, {0.99999F, 0, 1}, {}, seamless()), record.color, 1e-4F));
    EXPECT_TRUE(isNear(sample(texture, {1, 0, 0.99999F}, {}, seamless()), record.color, 1e-4F));
    EXPECT_EQ(sample(texture, {1, 0, 1}, {}, seamless()), record.color);
}

// Where +x, +y and +z meet: each has a third, and the weights add up to 1.
TEST(SampleOfASeamlessCubeMap, TakesTheMeanOfThreeAtACorner) {
    SampledTexture texture = cubeTexture(4);
    texture.magFilter = MagFilter::Linear;
    const SampleRecord record = explainSample(texture, {1, 1, 1}, {}, seamless());
    // The texels are (0, 0) of +x, (3, 3) of +y and (3, 0) of +z: red 0, 0.2, 0.4; green 0, 0.3, 0.3; blue 0,
    // 0.3, 0.
    EXPECT_TRUE(isNear(record.color, {0.2F, 0.2F, 0.1F, 1}));
    float sum = 0;
    for (const Tap& tap : record.taps)
        sum += tap.weight;
    EXPECT_FLOAT_EQ(sum, 1);
    for (const glm::ivec3 index : {glm::ivec3(0, 0, 0), glm::ivec3(3, 3, 2), glm::ivec3(3, 0, 4)})
        EXPECT_FLOAT_EQ(texelWeight(texture, {1, 1, 1}, {}, seamless(), {0, index}), 1.0F / 3);
    EXPECT_TRUE(isNear(sample(texture, {0.99999F, 1, 0.99999F}, {}, seamless()), record.color, 1e-4F));
}

TEST(SampleOfASeamlessCubeMap, TakesTheTexelOfTheFaceThatIsHitUnderNearest) {
    SampledTexture texture = cubeTexture(4);
    texture.wrapS = texture.wrapT = Wrap::ClampToBorder;
    for (const glm::vec3 direction : {glm::vec3(0.99999F, 0.3F, 1), glm::vec3(1, -1, -0.99999F)})
        EXPECT_EQ(sample(texture, direction, {}, seamless()), sample(texture, direction, {}));
}

TEST(SampleOfASeamlessCubeMap, BlendsTheEdgesOfEveryLevel) {
    SampledTexture texture = leveledTexture(8); // all faces alike, each level of one colour
    texture.target = Target::CubeMap;
    texture.otherFaces.assign(5, texture.levels);
    texture.minFilter = MinFilter::LinearMipmapLinear;
    for (Level& level : texture.otherFaces[3]) // +z
        std::ranges::fill(level.texels, glm::vec4(0, 1, 0, 1));
    // s of +x moves 2 of 8 texels a pixel: lambda 1, and half of level 1 is of either face.
    const SampleRecord record = explainSample(texture, {1, 0, 1}, {{0, 0, 0.5F}, {0, 0.5F, 0}}, seamless());
    EXPECT_NEAR(record.lod.lambda, 1, 1e-5F);
    const glm::vec4 own = texture.levels[1].texels[0];
    EXPECT_TRUE(isNear(record.color, (own + glm::vec4(0, 1, 0, 1)) / 2.0F, 1e-4F));
}

TEST(SampleOfASeamlessCubeMap, HasNoMeaningForOtherTargets) {
    SampledTexture texture = leveledTexture(8);
    texture.magFilter = MagFilter::Linear;
    texture.wrapS = texture.wrapT = Wrap::Repeat;
    EXPECT_EQ(sample(texture, {0, 0, 0}, {}, seamless()), sample(texture, {0, 0, 0}, {}));
}

TEST(CompletenessOfACubeMap, WantsSixSquaresOfOneSize) {
    SampledTexture texture = cubeTexture(4);
    EXPECT_TRUE(checkCompleteness(texture).complete());
    const SampledTexture whole = texture;

    texture.otherFaces[2][0] = makeLevel({2, 2, 1}, [](int, int, int) { return glm::vec4(1); });
    EXPECT_EQ(checkCompleteness(texture).rule, CompletenessRule::CubeFaces);
    EXPECT_EQ(
        checkCompleteness(texture).reason,
        "the texture is incomplete: the faces of a cube map must have one size; +x has 4 × 4 texels and "
        "-y 2 × 2");
    texture = whole;
    texture.otherFaces.pop_back();
    EXPECT_EQ(checkCompleteness(texture).reason,
              "the texture is incomplete: a cube map has six faces, and -z is missing");
    texture = whole;
    for (int face = 0; face < 6; ++face)
        texture.levelToFill(0, face) = makeLevel({4, 2, 1}, [](int, int, int) { return glm::vec4(1); });
    EXPECT_EQ(
        checkCompleteness(texture).reason,
        "the texture is incomplete: the faces of a cube map must be square, and they have 4 × 2 texels");

    texture = whole;
    texture.minFilter = MinFilter::LinearMipmapLinear;
    for (int level = 1; level < 3; ++level)
        for (int face = 0; face < 6; ++face)
            texture.levelToFill(level, face) =
                makeLevel({4 >> level, 4 >> level, 1}, [](int, int, int) { return glm::vec4(1); });
    EXPECT_TRUE(checkCompleteness(texture).complete());
    texture.otherFaces[4][1] = {};
    EXPECT_EQ(checkCompleteness(texture).rule, CompletenessRule::LevelMissing);
}

} // namespace
} // namespace texplorer::reference::cube_test
