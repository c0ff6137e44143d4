// Alpha test, depth test and blending: OpenGL 2.1, sections 4.1.4, 4.1.6 and 4.1.8.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

namespace texplorer::fragment_test {
namespace {

using namespace test;

struct CompareCase {
    const char* name;
    CompareFunc func;
    bool below; // passes where the new value is below the reference
    bool equal;
    bool above;
};

class Compare : public RenderTest, public testing::WithParamInterface<CompareCase> {
protected:
    static constexpr glm::vec4 background{0, 0, 1, 1};

    /// Whether the fragment's alpha passes the alpha test against the reference.
    bool passes(float alpha, float reference) {
        Scene scene = flatScene();
        scene.view.background = background;
        scene.material.color = {1, 0, 0, alpha};
        scene.passes[0].alphaTest = true;
        scene.passes[0].alphaFunc = GetParam().func;
        scene.passes[0].alphaRef = reference;
        const glm::vec4 found = onlyColor(scene);
        EXPECT_TRUE(isColor(found, background, 0) || isColor(found, {1, 0, 0, alpha}, 0));
        return found.r > 0.5F;
    }
};

TEST_P(Compare, AlphaTest) {
    EXPECT_EQ(passes(0, 1), GetParam().below);
    EXPECT_EQ(passes(1, 1), GetParam().equal);
    EXPECT_EQ(passes(1, 0), GetParam().above);
}

// Two squares fill the view. The first pass leaves the depth of the second one, because that is drawn last
// and always passes. In the second pass the first square is green and is compared with it; the second one is
// transparent there, and the alpha test drops it.
TEST_P(Compare, DepthTest) {
    images.put("image", rgbaImage(2, 1, 1, {{0, 255, 0, 255}, {0, 0, 0, 0}}));
    Scene scene = texturedScene();
    scene.models.push_back(scene.models[0]);
    scene.models[0].texCoords[0] = quadCoords({0.25F, 0.5F, 0, 1});
    scene.models[1].texCoords[0] = quadCoords({0.75F, 0.5F, 0, 1});

    Pass first;
    first.depthTest = true;
    first.depthFunc = CompareFunc::Always;
    Pass second = scene.passes[0];
    second.depthTest = true;
    second.depthFunc = GetParam().func;
    second.alphaTest = true;
    second.alphaFunc = CompareFunc::Greater;
    scene.passes = {first, second};

    const auto passesAt = [&](float z) {
        scene.models[0].position.z = z;
        const glm::vec4 found = onlyColor(scene);
        EXPECT_TRUE(isColor(found, {1, 1, 1, 1}, 0) || isColor(found, {0, 1, 0, 1}, 0));
        return found.r < 0.5F;
    };
    EXPECT_EQ(passesAt(0.25F), GetParam().below) << "nearer";
    EXPECT_EQ(passesAt(0), GetParam().equal) << "at the same depth";
    EXPECT_EQ(passesAt(-0.25F), GetParam().above) << "farther";
}

INSTANTIATE_TEST_SUITE_P(All, Compare,
                         testing::Values(CompareCase{"Never", CompareFunc::Never, false, false, false},
                                         CompareCase{"Less", CompareFunc::Less, true, false, false},
                                         CompareCase{"Equal", CompareFunc::Equal, false, true, false},
                                         CompareCase{"LessEqual", CompareFunc::LessEqual, true, true, false},
                                         CompareCase{"Greater", CompareFunc::Greater, false, false, true},
                                         CompareCase{"NotEqual", CompareFunc::NotEqual, true, false, true},
                                         CompareCase{"GreaterEqual", CompareFunc::GreaterEqual, false, true,
                                                     true},
                                         CompareCase{"Always", CompareFunc::Always, true, true, true}),
                         [](const auto& test) { return std::string(test.param.name); });

// Source (0.2, 0.4, 0.6, 0.8) over destination (0.4, 0.8, 0.2, 0.6).
constexpr glm::vec4 source{0.2F, 0.4F, 0.6F, 0.8F};
constexpr glm::vec4 destination{0.4F, 0.8F, 0.2F, 0.6F};

struct FactorCase {
    const char* name;
    BlendFactor factor;
    glm::vec4 value; // table 4.1
};

class Blend : public RenderTest, public testing::WithParamInterface<FactorCase> {
protected:
    glm::vec4 blended(BlendFactor src, BlendFactor dst) {
        Scene scene = flatScene();
        scene.view.background = destination;
        scene.material.color = source;
        scene.passes[0].blend = true;
        scene.passes[0].blendSrc = src;
        scene.passes[0].blendDst = dst;
        return onlyColor(scene);
    }
};

TEST_P(Blend, FactorOfTheSource) {
    EXPECT_TRUE(isColor(blended(GetParam().factor, BlendFactor::Zero), source * GetParam().value));
}
TEST_P(Blend, FactorOfTheDestination) {
    EXPECT_TRUE(isColor(blended(BlendFactor::Zero, GetParam().factor), destination * GetParam().value));
}

using B = BlendFactor;

INSTANTIATE_TEST_SUITE_P(
    All, Blend,
    testing::Values(FactorCase{"Zero", B::Zero, glm::vec4(0)}, FactorCase{"One", B::One, glm::vec4(1)},
                    FactorCase{"SrcColor", B::SrcColor, {0.2F, 0.4F, 0.6F, 0.8F}},
                    FactorCase{"OneMinusSrcColor", B::OneMinusSrcColor, {0.8F, 0.6F, 0.4F, 0.2F}},
                    FactorCase{"SrcAlpha", B::SrcAlpha, glm::vec4(0.8F)},
                    FactorCase{"OneMinusSrcAlpha", B::OneMinusSrcAlpha, glm::vec4(0.2F)},
                    FactorCase{"DstAlpha", B::DstAlpha, glm::vec4(0.6F)},
                    FactorCase{"OneMinusDstAlpha", B::OneMinusDstAlpha, glm::vec4(0.4F)},
                    FactorCase{"DstColor", B::DstColor, {0.4F, 0.8F, 0.2F, 0.6F}},
                    FactorCase{"OneMinusDstColor", B::OneMinusDstColor, {0.6F, 0.2F, 0.8F, 0.4F}}),
    [](const auto& test) { return std::string(test.param.name); });

class Passes : public RenderTest {};

// Each pass leaves half of what is there.
TEST_F(Passes, ThatAreOffChangeNothing) {
    Scene scene = flatScene();
    scene.view.background = {1, 0, 0, 1};
    Pass& first = scene.passes[0];
    first.blend = true;
    first.blendSrc = BlendFactor::Zero;
    first.blendDst = BlendFactor::SrcColor;
    scene.material.color = {0.5F, 0.5F, 0.5F, 1};
    scene.passes.push_back(first);
    EXPECT_TRUE(isColor(onlyColor(scene), {0.25F, 0, 0, 1}, 1));
    scene.passes[0].enabled = false;
    EXPECT_TRUE(isColor(onlyColor(scene), {0.5F, 0, 0, 1}, 1));
    scene.passes[1].enabled = false;
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}, 0));
    EXPECT_TRUE(problems.empty());
}

TEST_F(Passes, ThatAreOffNeedNoTexture) {
    Scene scene = texturedScene(); // of a file that isn't there
    scene.passes[0].enabled = false;
    EXPECT_TRUE(isColor(onlyColor(scene), scene.view.background, 0));
    EXPECT_TRUE(problems.empty());
}

// Units, lighting and texture coordinates change between passes; positions must not, to the last bit.
TEST_F(Passes, ASecondPassWithEqualDepthHitsExactlyTheFirst) {
    images.put("image", plainImage(1, 1, {0, 255, 0, 255}));
    Scene scene = defaultScene();
    scene.textures = texturedScene().textures;
    Pass green = scene.passes[0];
    green.lighting = false;
    green.units[0].envMode = EnvMode::Replace;
    scene.passes = {green};
    const Image once = picture(scene, 128);

    Pass lit = green;
    lit.lighting = true;
    lit.units[0].enabled = false;
    green.depthFunc = CompareFunc::Equal;
    scene.passes = {lit, green};
    EXPECT_EQ(picture(scene, 128), once);
}

} // namespace
} // namespace texplorer::fragment_test
