// Depth textures on the driver: section 3.8.14 of the OpenGL 2.1 specification, and pictures of what the
// light sees held against the reference.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/reference/draw.h"

#include <gmock/gmock.h>

namespace texplorer::depth_texture_test {
namespace {

using namespace test;
using testing::Contains;
using testing::HasSubstr;

/// Of the pixels, how many differ by more than 2/255.
double shareOver(const Image& a, const Image& b) {
    std::size_t over = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x)
            over += isColor(colorAt(a, x, y), colorAt(b, x, y), 2) ? 0U : 1U;
    }
    return static_cast<double>(over) / (a.width * a.height);
}

class DepthTexture : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        images.put("image",
                   rgbaImage(4, 1, 1, {{0, 9, 9, 9}, {51, 9, 9, 9}, {102, 9, 9, 9}, {255, 9, 9, 9}}));
    }

    /// A quad that samples at one place. Its depths are 0, 0.2, 0.4 and 1.
    [[nodiscard]] Scene sceneAt(float s, float r, InternalFormat format = InternalFormat::DepthComponent24) {
        Scene scene = texturedScene();
        scene.textures[0].internalFormat = format;
        scene.textures[0].wrapS = Wrap::ClampToBorder;
        scene.models[0].texCoords[0] = quadCoords({s, 0.5F, r, 1});
        return scene;
    }
    [[nodiscard]] static float centreOf(int texel) { return (static_cast<float>(texel) + 0.5F) / 4; }
};

TEST_F(DepthTexture, IsAGreyWhereNothingIsCompared) {
    for (const InternalFormat format : {InternalFormat::DepthComponent16, InternalFormat::DepthComponent24,
                                        InternalFormat::DepthComponent, InternalFormat::DepthComponent32}) {
        EXPECT_TRUE(isColor(onlyColor(sceneAt(centreOf(1), 9, format)), {0.2F, 0.2F, 0.2F, 1}));
        EXPECT_TRUE(isColor(onlyColor(sceneAt(centreOf(2), 9, format)), {0.4F, 0.4F, 0.4F, 1}));
    }
    EXPECT_TRUE(problems.empty());
}

TEST_F(DepthTexture, ComparesRAsTheFunctionSays) {
    struct Row {
        CompareFunc function;
        std::array<int, 3> passes; ///< of r = 0.1, 0.3 and 7 against 0.2, 0.2 and 1
    };
    for (const auto& [function, passes] :
         {Row{CompareFunc::Never, {0, 0, 0}}, Row{CompareFunc::Less, {1, 0, 0}},
          Row{CompareFunc::Equal, {0, 0, 1}}, Row{CompareFunc::LessEqual, {1, 0, 1}},
          Row{CompareFunc::Greater, {0, 1, 0}}, Row{CompareFunc::NotEqual, {1, 1, 0}},
          Row{CompareFunc::GreaterEqual, {0, 1, 1}}, Row{CompareFunc::Always, {1, 1, 1}}}) {
        const auto result = [&](int texel, float r) {
            Scene scene = sceneAt(centreOf(texel), r);
            scene.textures[0].compareMode = CompareMode::RToTexture;
            scene.textures[0].compareFunc = function;
            return onlyColor(scene);
        };
        EXPECT_EQ(result(1, 0.1F).r, static_cast<float>(passes[0])) << rowOf(function).name;
        EXPECT_EQ(result(1, 0.3F).r, static_cast<float>(passes[1])) << rowOf(function).name;
        EXPECT_EQ(result(3, 7).r, static_cast<float>(passes[2])) << rowOf(function).name << ", clamped";
        EXPECT_EQ(result(1, 0.3F).a, 1);
    }
}

TEST_F(DepthTexture, DividesRByQ) {
    Scene scene = sceneAt(0, 0);
    scene.textures[0].compareMode = CompareMode::RToTexture;
    scene.models[0].texCoords[0] = quadCoords({2 * centreOf(1), 1, 0.3F, 2}); // 0.15 against 0.2
    EXPECT_EQ(onlyColor(scene).r, 1);
}

// u = 2: half of 0.2 and half of 0.4. r = 0.35 passes against one of them, and not against their mean.
TEST_F(DepthTexture, FiltersWhatComesOfComparing) {
    Scene scene = sceneAt(0.5F, 0.35F);
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    scene.textures[0].compareMode = CompareMode::RToTexture;
    EXPECT_TRUE(isColor(onlyColor(scene), {0.5F, 0.5F, 0.5F, 1}));
    scene.passes[0].units[0].lodBias = 0.5F; // another GLSL function
    EXPECT_TRUE(isColor(onlyColor(scene), {0.5F, 0.5F, 0.5F, 1}));
}

TEST_F(DepthTexture, BecomesWhatTheModeSays) {
    for (const auto& [mode, color] : {std::pair{DepthMode::Luminance, glm::vec4(0.2F, 0.2F, 0.2F, 0.9F)},
                                      std::pair{DepthMode::Intensity, glm::vec4(0.2F)},
                                      std::pair{DepthMode::Alpha, glm::vec4(0.6F, 0.7F, 0.8F, 0.2F)}}) {
        for (const CompareMode compare : {CompareMode::None, CompareMode::RToTexture}) {
            Scene scene = sceneAt(centreOf(1), 0.3F);
            scene.material.color = {0.6F, 0.7F, 0.8F, 0.9F}; // what GL_REPLACE leaves of it
            scene.textures[0].depthMode = mode;
            scene.textures[0].compareMode = compare;
            glm::vec4 expected = color;
            if (compare == CompareMode::RToTexture) // 0.3 fails
                expected = mode == DepthMode::Alpha       ? glm::vec4(0.6F, 0.7F, 0.8F, 0)
                           : mode == DepthMode::Luminance ? glm::vec4(0, 0, 0, 0.9F)
                                                          : glm::vec4(0);
            EXPECT_TRUE(isColor(onlyColor(scene), expected)) << rowOf(mode).name;
        }
    }
}

TEST_F(DepthTexture, ComparesWithTheRedOfTheBorderColour) {
    Scene scene = sceneAt(3, 0.5F);
    scene.textures[0].borderColor = {0.6F, 0, 0, 0};
    scene.textures[0].compareMode = CompareMode::RToTexture;
    EXPECT_EQ(onlyColor(scene).r, 1);
    scene.textures[0].borderColor.r = 0.4F;
    EXPECT_EQ(onlyColor(scene).r, 0);
}

TEST_F(DepthTexture, IsALineAsWell) {
    Scene scene = sceneAt(centreOf(1), 0.3F);
    scene.passes[0].units[0].target = Target::Texture1D;
    EXPECT_TRUE(isColor(onlyColor(scene), {0.2F, 0.2F, 0.2F, 1}));
    scene.textures[0].compareMode = CompareMode::RToTexture;
    for (const float t : {0.1F, 0.5F}) { // a line has no t
        scene.models[0].texCoords[0] = quadCoords({centreOf(1), t, 0.3F, 1});
        EXPECT_EQ(onlyColor(scene).r, 0);
        scene.models[0].texCoords[0] = quadCoords({centreOf(1), t, 0.1F, 1});
        EXPECT_EQ(onlyColor(scene).r, 1);
    }
    EXPECT_TRUE(problems.empty());
}

// llvmpipe's anisotropic filter compares no depths, or, since Mesa 25, draws black where coordinates don't
// change.
TEST_F(DepthTexture, IsComparedWhateverTheAnisotropyIs) {
    const auto at = [&](float r) {
        Scene scene = sceneAt(centreOf(1), r);
        scene.textures[0].compareMode = CompareMode::RToTexture;
        scene.textures[0].maxAnisotropy = 4;
        return scene;
    };
    EXPECT_TRUE(isColor(onlyColor(at(0.1F)), {1, 1, 1, 1}));
    EXPECT_TRUE(isColor(onlyColor(at(0.3F)), {0, 0, 0, 1}));
    if (capabilities.renderer.starts_with("llvmpipe")) {
        EXPECT_THAT(problems, Contains(HasSubstr("drawn without anisotropy")));
    }
}

TEST_F(DepthTexture, IsLeftOutOfOtherTargetsWithASentence) {
    for (const Target target : {Target::Texture3D, Target::CubeMap}) {
        Scene scene = sceneAt(centreOf(1), 0);
        scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
        scene.passes[0].units[0].target = target;
        EXPECT_TRUE(isColor(onlyColor(scene), scene.material.color));
        EXPECT_THAT(problems, Contains(HasSubstr("OpenGL has no depth textures for")));
        const Result<Frame> frame = reference::drawReference({scene, images, 0, 8, 8});
        ASSERT_TRUE(frame);
        EXPECT_EQ(frame->problems, problems);
    }
}

// An image of 24 bits in each format, as the driver has it.
TEST_F(DepthTexture, KeepsItsBits) {
    for (const auto& [format, bits] :
         {std::pair{InternalFormat::DepthComponent16, 16}, std::pair{InternalFormat::DepthComponent24, 24},
          std::pair{InternalFormat::DepthComponent, 24}, std::pair{InternalFormat::DepthComponent32, 32}}) {
        Image depths = Image::uninitialised(PixelFormat::Depth32, 16, 4);
        for (int i = 0; i < 64; ++i)
            storeDepth(widenedDepth(static_cast<std::uint32_t>(i) * 266305U, 24),
                       depths.pixels.data() + std::ptrdiff_t{4} * i);
        Scene scene = sceneAt(0, 0, format);
        scene.textures[0].source = SourceKind::LightDepth;
        scene.textures[0].depthSize = 16;
        images.putLightDepth(16, drawnImage(depths));
        static_cast<void>(picture(scene));
        EXPECT_TRUE(problems.empty());
        const Result<std::vector<TextureLevel>> read = renderer->readTexture(0);
        ASSERT_TRUE(read);
        const Image& held = std::get<Image>(*read->at(0).surface);
        ASSERT_EQ(held.format, PixelFormat::Depth32);
        const Image expected = depthsOf(depths, bits);
        for (std::size_t i = 0; i < 64; ++i)
            EXPECT_EQ(depthAt(held.pixels.data() + 4 * i) >> (32 - bits),
                      depthAt(expected.pixels.data() + 4 * i) >> (32 - bits))
                << bits << " " << i;
    }
}

/// A cube and a floor below a light, seen from the side.
Scene shadows() {
    Scene scene = defaultScene();
    scene.view.elevation = 30;
    scene.view.distance = 7;
    scene.models[0].position = {0, 0.8F, 0};
    scene.models[0].spin = {0, 90, 0};
    scene.models[1].shape = Shape::Floor;
    scene.models[1].size = 0.3F;
    scene.models[1].position = {0, -1, 0};
    scene.light.position = {2, 5, -5, 1};
    scene.light.projector = {{0, -0.5F, -7}, 70, 2, 12};
    Texture& texture = scene.textures[0];
    texture.source = SourceKind::LightDepth;
    texture.depthSize = 128;
    texture.mipmaps = MipPolicy::None;
    texture.internalFormat = InternalFormat::DepthComponent24;
    texture.minFilter = MinFilter::Linear;
    texture.compareMode = CompareMode::RToTexture;
    Unit& unit = scene.passes[0].units[0];
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -0.01F}}, {.op = MatrixOp::Projector}};
    int axis = 0;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ}) {
        each->enabled = true;
        each->eyePlane = glm::vec4(0);
        each->eyePlane[axis++] = 1;
    }
    return scene;
}

TEST_F(DepthTexture, OfTheLightCastsTheShadowsOfTheReference) {
    const Scene scene = shadows();
    for (const double time : {0.0, 0.5}) {
        const Image theirs = picture(scene, 96, time);
        EXPECT_TRUE(problems.empty());
        const Result<Frame> ours = reference::drawReference({scene, images, time, 96, 96});
        ASSERT_TRUE(ours);
        EXPECT_LT(shareOver(ours->image, theirs), 0.01) << time;
    }
    Scene lit = scene;
    lit.textures[0].compareFunc = CompareFunc::Always;
    EXPECT_GT(shareOver(picture(lit, 96), picture(scene, 96)), 0.05) << "there are shadows";
}

TEST_F(DepthTexture, OfTheLightFollowsWhatMoves) {
    Scene scene = shadows();
    const Image first = picture(scene, 64, 0);
    EXPECT_NE(picture(scene, 64, 0.5), first);
    EXPECT_EQ(picture(scene, 64, 0), first);
    scene.light.position.x = -2;
    EXPECT_NE(picture(scene, 64, 0), first);
}

} // namespace
} // namespace texplorer::depth_texture_test
