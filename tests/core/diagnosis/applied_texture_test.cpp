#include "tests/support/flat_scene.h"
#include "texplorer/diagnosis/applied_texture.h"

#include <gtest/gtest.h>

namespace texplorer::applied_texture_test {
namespace {

/// A texture of 2^(count - 1) texels along each axis, with that many levels.
reference::SampledTexture shapeWith(int count, Target target = Target::Texture2D) {
    reference::SampledTexture shape;
    shape.target = target;
    for (int level = 0; level < count; ++level) {
        const int extent = 1 << (count - 1 - level);
        for (int face = 0; face < facesOf(target); ++face)
            shape.levelToFill(level, face) = {
                extent, axesOf(target) > 1 ? extent : 1, axesOf(target) > 2 ? extent : 1, 0, {}};
    }
    return shape;
}

DriverFacts named(const char* renderer) {
    DriverFacts facts;
    facts.renderer = renderer;
    return facts;
}

const DriverFacts llvmpipe = named("llvmpipe (LLVM 15.0.6, 256 bits)");

struct LevelCase {
    const char* name;
    int base;
    int max;
    MinFilter filter;
    bool complete;
    int applied; ///< the maximal level
};

void PrintTo(const LevelCase& each, std::ostream* out) {
    *out << each.name;
}

class AppliedLevels : public testing::TestWithParam<LevelCase> {};

// Sections 3.8.8 and 3.8.10: without mipmaps the base level alone counts, wherever the maximal level is.
TEST_P(AppliedLevels, AreThere) {
    const LevelCase& given = GetParam();
    Texture texture;
    texture.baseLevel = given.base;
    texture.maxLevel = given.max;
    texture.minFilter = given.filter;
    const AppliedTexture applied = appliedTexture(texture, shapeWith(4), 1000, {});
    EXPECT_EQ(applied.completeness.complete(), given.complete) << applied.completeness.reason;
    if (given.complete) {
        EXPECT_EQ(applied.texture.maxLevel, given.applied);
        EXPECT_GE(applied.texture.maxLevel, applied.texture.baseLevel);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, AppliedLevels,
    testing::Values(LevelCase{"AllOfThem", 0, 1000, MinFilter::LinearMipmapLinear, true, 1000},
                    LevelCase{"MaxBelowBase", 1, 0, MinFilter::Nearest, true, 1},
                    LevelCase{"MaxBelowBaseWithMipmaps", 1, 0, MinFilter::NearestMipmapNearest, false, 0},
                    LevelCase{"MaxAtBase", 3, 3, MinFilter::Linear, true, 3},
                    LevelCase{"BaseBeyond", 4, 1000, MinFilter::Linear, false, 0},
                    LevelCase{"BaseFarBeyond", 1000, 1000, MinFilter::Nearest, false, 0},
                    LevelCase{"NegativeMax", 0, -3, MinFilter::Nearest, true, 0}),
    [](const auto& each) { return each.param.name; });

TEST(AppliedTexture, KeepsTheLimitOfAShortFile) {
    Texture texture;
    texture.minFilter = MinFilter::LinearMipmapLinear;
    EXPECT_EQ(appliedTexture(texture, shapeWith(4), 2, {}).texture.maxLevel, 2);
    texture.baseLevel = -1; // GL refuses it and keeps 0
    EXPECT_EQ(appliedTexture(texture, shapeWith(4), 2, {}).texture.baseLevel, 0);
}

Texture anisotropic(MinFilter min, MagFilter mag) {
    Texture texture;
    texture.minFilter = min;
    texture.magFilter = mag;
    texture.maxAnisotropy = 4;
    return texture;
}

TEST(AppliedTexture, GivesLlvmpipeNoAnisotropyForALine) {
    const Texture texture = anisotropic(MinFilter::LinearMipmapLinear, MagFilter::Linear);
    const AppliedTexture held = appliedTexture(texture, shapeWith(4, Target::Texture1D), 1000, llvmpipe);
    EXPECT_EQ(held.texture.maxAnisotropy, 1);
    ASSERT_EQ(held.heldBack.size(), 1U);
    EXPECT_NE(held.heldBack[0].find("GL_TEXTURE_1D"), std::string_view::npos);
    const AppliedTexture other =
        appliedTexture(texture, shapeWith(4, Target::Texture1D), 1000, named("AMD Radeon"));
    EXPECT_EQ(other.texture, texture);
    EXPECT_TRUE(other.heldBack.empty());
}

TEST(AppliedTexture, LeavesAllOtherAnisotropyAsItIs) {
    for (const Target target : {Target::Texture2D, Target::Texture3D, Target::CubeMap}) {
        for (const MagFilter mag : {MagFilter::Nearest, MagFilter::Linear}) {
            const Texture texture = anisotropic(MinFilter::LinearMipmapLinear, mag);
            const AppliedTexture applied = appliedTexture(texture, shapeWith(4, target), 1000, llvmpipe);
            EXPECT_EQ(applied.texture, texture) << rowOf(target).name;
            EXPECT_TRUE(applied.heldBack.empty());
        }
    }
}

TEST(AppliedTexture, GivesLlvmpipeNoAnisotropyForDepthsThatAreCompared) {
    Texture texture = anisotropic(MinFilter::Linear, MagFilter::Linear);
    texture.internalFormat = InternalFormat::DepthComponent24;
    EXPECT_EQ(appliedTexture(texture, shapeWith(4), 1000, llvmpipe).texture.maxAnisotropy, 4);
    texture.compareMode = CompareMode::RToTexture;
    const AppliedTexture held = appliedTexture(texture, shapeWith(4), 1000, llvmpipe);
    EXPECT_EQ(held.texture.maxAnisotropy, 1);
    ASSERT_EQ(held.heldBack.size(), 1U);
    EXPECT_NE(held.heldBack[0].find("compares no depths"), std::string_view::npos);
    EXPECT_EQ(appliedTexture(texture, shapeWith(4), 1000, named("softpipe")).texture.maxAnisotropy, 4);
}

TEST(AppliedTexture, GivesLlvmpipeNoAnisotropyWhereItWouldVisitTexelsWithoutEnd) {
    const Texture texture = anisotropic(MinFilter::Linear, MagFilter::Linear);
    Scene scene = test::texturedScene();
    scene.textures[0] = texture;
    const TextureUse use{scene, 0, 0, 64, 64};
    EXPECT_EQ(appliedTexture(texture, shapeWith(7), 1000, llvmpipe, &use).texture.maxAnisotropy, 4);
    scene.models[0].texCoords[0] = test::quadCoords({0, 0, 0, 1}, {1000, 1000, 0, 1});
    const AppliedTexture held = appliedTexture(texture, shapeWith(7), 1000, llvmpipe, &use);
    EXPECT_EQ(held.texture.maxAnisotropy, 1);
    ASSERT_EQ(held.heldBack.size(), 1U);
    EXPECT_NE(held.heldBack[0].find("visits every texel"), std::string_view::npos);
    const Texture mipmapped = anisotropic(MinFilter::LinearMipmapLinear, MagFilter::Linear);
    EXPECT_EQ(appliedTexture(mipmapped, shapeWith(7), 1000, llvmpipe, &use).texture.maxAnisotropy, 4);
    scene.models[0].texCoords[0].edit()[0].q = -1;
    EXPECT_EQ(appliedTexture(mipmapped, shapeWith(7), 1000, llvmpipe, &use).texture.maxAnisotropy, 1);
    EXPECT_EQ(appliedTexture(texture, shapeWith(7), 1000, named("AMD Radeon"), &use).texture, texture);
}

TEST(AppliedTexture, GivesLlvmpipeOfMesa25NoAnisotropyWhereCoordinatesDoNotChange) {
    DriverFacts newer = llvmpipe;
    newer.version = "4.5 (Compatibility Profile) Mesa 25.0.7-2";
    const Texture texture = anisotropic(MinFilter::Linear, MagFilter::Linear);
    Scene scene = test::texturedScene();
    scene.textures[0] = texture;
    const TextureUse use{scene, 0, 0, 64, 64};
    scene.models[0].texCoords[0] = test::quadCoords({0, 0, 0, 1}, {1000, 1000, 0, 1});
    EXPECT_TRUE(appliedTexture(texture, shapeWith(7), 1000, newer, &use).heldBack.empty());
    scene.models[0].texCoords[0] = test::quadCoords({0.3F, 0.3F, 0, 1});
    const AppliedTexture held = appliedTexture(texture, shapeWith(7), 1000, newer, &use);
    EXPECT_EQ(held.texture.maxAnisotropy, 1);
    ASSERT_EQ(held.heldBack.size(), 1U);
    EXPECT_NE(held.heldBack[0].find("draws black"), std::string_view::npos);
    EXPECT_TRUE(appliedTexture(texture, shapeWith(4), 1000, llvmpipe, &use).heldBack.empty());
}

// Mesa makes a whole number of it, downwards.
TEST(AppliedTexture, LeavesAnisotropyBelowTwoAsItIs) {
    Texture texture = anisotropic(MinFilter::Linear, MagFilter::Nearest);
    texture.maxAnisotropy = 1.9F;
    EXPECT_EQ(appliedTexture(texture, shapeWith(4, Target::Texture1D), 1000, llvmpipe).texture, texture);
}

// The filters are all that llvmpipe's anisotropy ignores.
TEST(AppliedTexture, GivesLlvmpipeOneFilterWhereLambdaChoosesNoLevel) {
    const Texture plain = anisotropic(MinFilter::Linear, MagFilter::Nearest);
    const AppliedTexture alone = appliedTexture(plain, shapeWith(1), 1000, llvmpipe);
    EXPECT_EQ(alone.texture.magFilter, MagFilter::Linear);
    EXPECT_TRUE(alone.heldBack.empty());
    EXPECT_EQ(appliedTexture(plain, shapeWith(4), 1000, {}).texture.magFilter, MagFilter::Nearest);
    const Texture oneLevel = anisotropic(MinFilter::NearestMipmapNearest, MagFilter::Linear);
    const AppliedTexture applied = appliedTexture(oneLevel, shapeWith(1), 1000, llvmpipe);
    EXPECT_EQ(applied.texture.magFilter, MagFilter::Nearest);
    EXPECT_EQ(applied.texture.maxAnisotropy, 4);
    EXPECT_TRUE(applied.heldBack.empty());
}

// With two filters llvmpipe itself would read other levels, as the program does that emit writes.
TEST(AppliedTexture, SaysWhereLlvmpipeWouldReadLevelsThatTheFilterLacks) {
    Texture texture = anisotropic(MinFilter::Nearest, MagFilter::Linear);
    const AppliedTexture held = appliedTexture(texture, shapeWith(4), 1000, llvmpipe);
    EXPECT_EQ(held.texture.magFilter, MagFilter::Nearest);
    ASSERT_EQ(held.heldBack.size(), 1U);
    EXPECT_NE(held.heldBack[0].find("reads mipmap levels"), std::string_view::npos);
    texture.maxLevel = 0; // there is none to read
    EXPECT_TRUE(appliedTexture(texture, shapeWith(4), 1000, llvmpipe).heldBack.empty());
    const Texture same = anisotropic(MinFilter::Nearest, MagFilter::Nearest);
    EXPECT_EQ(appliedTexture(same, shapeWith(4), 1000, llvmpipe).texture, same);
}

} // namespace
} // namespace texplorer::applied_texture_test
