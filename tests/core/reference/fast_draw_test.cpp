// The quick way to draw against the literal one: the same bytes, whatever the number of threads.

#include "core/reference/draw.h"
#include "core/scene/param_text.h"

#include <gtest/gtest.h>

namespace texplorer::reference {
namespace {

Image drawn(const Scene& scene, const DrawOptions& options) {
    const Result<Drawn> result = drawReference(scene, ImageSource(), 0.5, 97, 61, options);
    EXPECT_TRUE(result) << describe(result.error());
    return result ? result->image : Image{};
}

void expectTheSame(const Scene& scene, DrawOptions options = {}) {
    options.literal = true;
    const Image literal = drawn(scene, options);
    options.literal = false;
    for (const unsigned threads : {1U, 2U, 3U, 7U}) {
        options.threads = threads;
        EXPECT_EQ(drawn(scene, options), literal) << threads << " threads";
    }
}

Scene floorScene() {
    Scene scene;
    scene.view.azimuth = 20;
    scene.view.elevation = 15;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Floor;
    scene.textures.resize(1);
    scene.textures[0].mipmaps = MipPolicy::Generated;
    scene.passes[0].depthTest = true;
    scene.passes[0].units[0].enabled = true;
    return scene;
}

/// A second, different texture in unit 2.
Unit& secondUnit(Scene& scene) {
    scene.textures.resize(2);
    scene.textures[1].pattern = Pattern::Tree;
    scene.textures[1].minFilter = MinFilter::Linear;
    Unit& unit = scene.passes[0].units[2];
    unit.enabled = true;
    unit.texture = 1;
    unit.matrix = {{.op = MatrixOp::Scale, .amount = {2, 3, 1}}};
    return unit;
}

struct Case {
    const char* name;
    void (*edit)(Scene& scene);
};
class FastDraw : public testing::TestWithParam<Case> {};

TEST_P(FastDraw, GivesTheBytesOfTheLiteralOne) {
    for (Scene scene : {defaultScene(), floorScene()}) {
        GetParam().edit(scene);
        expectTheSame(scene);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, FastDraw,
    testing::Values(
        Case{"AsItIs", [](Scene&) {}},
        Case{"Untextured", [](Scene& it) { it.passes[0].units[0].enabled = false; }},
        Case{"Nearest",
             [](Scene& it) {
                 it.textures[0].magFilter = MagFilter::Nearest;
                 it.textures[0].minFilter = MinFilter::Nearest;
             }},
        Case{"MixedFilters", [](Scene& it) { it.textures[0].minFilter = MinFilter::NearestMipmapLinear; }},
        Case{"Anisotropic", [](Scene& it) { it.textures[0].maxAnisotropy = 16; }},
        Case{"Border",
             [](Scene& it) {
                 it.textures[0].wrapS = Wrap::ClampToBorder;
                 it.textures[0].wrapT = Wrap::Clamp;
                 it.textures[0].borderColor = {1, 0.5F, 0, 1};
                 it.passes[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {3, 2, 1}}};
             }},
        Case{"TargetOfOneAxis", [](Scene& it) { it.passes[0].units[0].target = Target::Texture1D; }},
        Case{"TargetOfThreeAxes", [](Scene& it) { it.passes[0].units[0].target = Target::Texture3D; }},
        Case{"Projective",
             [](Scene& it) {
                 it.passes[0].units[0].texGenQ = {
                     .enabled = true, .mode = TexGenMode::ObjectLinear, .objectPlane = {0.3F, 0.1F, 0.2F, 1}};
             }},
        Case{"Reflected",
             [](Scene& it) {
                 it.passes[0].units[0].texGenS = {.enabled = true, .mode = TexGenMode::SphereMap};
                 it.passes[0].units[0].texGenT = {.enabled = true, .mode = TexGenMode::SphereMap};
             }},
        Case{"Flat", [](Scene& it) { it.material.shadeModel = ShadeModel::Flat; }},
        Case{"SeparateSpecular", [](Scene& it) { it.light.colorControl = ColorControl::SeparateSpecular; }},
        Case{"AlphaTested",
             [](Scene& it) {
                 it.textures[0].pattern = Pattern::Tree;
                 it.textures[0].internalFormat = BaseFormat::Alpha;
                 it.passes[0].alphaTest = true;
                 it.passes[0].alphaFunc = CompareFunc::Greater;
                 it.passes[0].alphaRef = 0.5F;
             }},
        Case{"Blended",
             [](Scene& it) {
                 it.material.color.a = 0.4F;
                 it.passes[0].depthTest = false;
                 it.passes[0].blend = true;
                 it.passes[0].blendSrc = BlendFactor::SrcAlpha;
                 it.passes[0].blendDst = BlendFactor::OneMinusSrcAlpha;
             }},
        Case{"TwoPasses",
             [](Scene& it) {
                 it.passes.resize(2, it.passes[0]);
                 it.passes[1].depthFunc = CompareFunc::LessEqual;
                 it.passes[1].blend = true;
                 it.passes[1].blendSrc = BlendFactor::DstColor;
                 it.passes[1].blendDst = BlendFactor::SrcColor;
             }},
        Case{"TwoUnits", [](Scene& it) { secondUnit(it).envMode = EnvMode::Decal; }},
        Case{"Combined",
             [](Scene& it) {
                 Unit& unit = secondUnit(it);
                 unit.envMode = EnvMode::Combine;
                 unit.envColor = {0.3F, 0.6F, 0.9F, 0.5F};
                 unit.combine.rgb = CombineRgb::Interpolate;
                 unit.combine.source0Rgb = CombineSource::Texture0;
             }},
        Case{"UnderTheNose", [](Scene& it) { it.view.distance = 1.2F; }},
        Case{"FarAway", [](Scene& it) { it.view.distance = 300; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FastDraw, GivesTheBytesOfTheLiteralOneInEveryEnvironment) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = Pattern::Tree;
    scene.material.color = {0.9F, 0.7F, 0.5F, 0.8F};
    Unit& unit = scene.passes[0].units[0];
    unit.envColor = {0.3F, 0.6F, 0.9F, 0.5F};
    for (const EnumRow& mode : envModeRows) {
        for (const EnumRow& format : baseFormatRows) {
            SCOPED_TRACE(std::string(mode.name) + " " + std::string(format.name));
            unit.envMode = static_cast<EnvMode>(mode.value);
            scene.textures[0].internalFormat = static_cast<BaseFormat>(format.value);
            expectTheSame(scene);
        }
    }
}

TEST(FastDraw, GivesTheBytesOfTheLiteralOneForEveryDepthFunction) {
    Scene scene = defaultScene();
    scene.models[1].position = scene.models[0].position; // they cut each other
    scene.passes.resize(2, scene.passes[0]);
    for (const EnumRow& row : compareFuncRows) {
        SCOPED_TRACE(row.name);
        scene.passes[1].depthFunc = static_cast<CompareFunc>(row.value);
        expectTheSame(scene);
    }
}

TEST(FastDraw, GivesTheBytesOfTheLiteralOneWithOtherOptions) {
    for (Scene scene : {defaultScene(), floorScene()}) {
        scene.view.perspectiveHint = HintMode::Fastest;
        expectTheSame(scene);
        scene.view.perspectiveHint = HintMode::DontCare;
        scene.textures[0].maxAnisotropy = 8;
        expectTheSame(scene, {.anisotropy = AnisotropyMethod::Ellipse});
    }
}

} // namespace
} // namespace texplorer::reference
