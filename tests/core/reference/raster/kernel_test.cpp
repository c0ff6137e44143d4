// The kernels against the literal way to draw: the same bytes, whatever the number of threads.

#include "tests/support/floor_scene.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/raster/kernel.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"

#include <gtest/gtest.h>

#include <utility>

namespace texplorer::reference::kernel_test {
namespace {

using test::floorScene;

Image drawn(const Scene& scene, const DrawOptions& options,
            AnisotropyMethod anisotropy = AnisotropyMethod::Probes, RhoMethod rho = RhoMethod::Ideal) {
    const Result<Frame> result = drawReference({scene, {}, 0.5, 97, 61, anisotropy, rho}, options);
    EXPECT_TRUE(result) << describe(result.error());
    return result ? result->image : Image{};
}

void expectTheSame(const Scene& scene, AnisotropyMethod anisotropy = AnisotropyMethod::Probes,
                   RhoMethod rho = RhoMethod::Ideal) {
    const Image literal = drawn(scene, {.literal = true}, anisotropy, rho);
    DrawOptions options;
    for (const Kernel* kernel : kernels()) {
        options.kernel = kernel;
        for (const unsigned threads : {1U, 3U}) {
            options.threads = threads;
            EXPECT_EQ(drawn(scene, options, anisotropy, rho), literal)
                << kernel->lanes << " lanes, " << threads << " threads";
        }
    }
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

/// Other coordinates than the mesh's, all of them so many times as large.
void scaleCoordinates(Scene& scene, float factor) {
    for (Model& model : scene.models) {
        for (const Vertex& vertex : meshOf(model).vertices)
            model.texCoords[0].push_back(glm::vec4(factor, factor, factor, 1) * vertex.texCoord);
    }
}

struct Case {
    const char* name;
    void (*edit)(Scene& scene);
};
class KernelTest : public testing::TestWithParam<Case> {};

TEST_P(KernelTest, GivesTheBytesOfTheLiteralOne) {
    for (Scene scene : {defaultScene(), floorScene()}) {
        GetParam().edit(scene);
        expectTheSame(scene);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, KernelTest,
    testing::Values(
        Case{"AsItIs", [](Scene&) {}}, Case{"Unlit", [](Scene& it) { it.passes[0].lighting = false; }},
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
        Case{"TwoSided", [](Scene& it) { it.light.twoSide = true; }},
        Case{"OpenAndTwoSided",
             [](Scene& it) {
                 it.models[0].shape = Shape::Cylinder;
                 it.models[0].texCoords = {};
                 it.models[0].rotation = {60, 20, 0};
                 it.light.twoSide = true;
                 it.light.colorControl = ColorControl::SeparateSpecular;
             }},
        Case{"Fog",
             [](Scene& it) {
                 it.passes[0].fog = {true, FogMode::Exp, 0.1F, 0, 1, {0.4F, 0.5F, 0.6F, 1}};
             }},
        Case{"FogSquared",
             [](Scene& it) {
                 it.passes[0].fog = {true, FogMode::Exp2, 0.1F, 0, 1, {2, -1, 0.6F, 1}};
                 it.passes[0].units[0].enabled = false;
             }},
        Case{"LinearFogOfOneColor",
             [](Scene& it) {
                 it.passes[0].fog = {true, FogMode::Linear, 1, 2, 12, {0.4F, 0.5F, 0.6F, 1}};
                 it.passes[0].lighting = false;
             }},
        Case{"FogBlendedAfterAHighlight",
             [](Scene& it) {
                 it.passes[0].fog = {true, FogMode::Linear, 1, 2, 12, {0.4F, 0.5F, 0.6F, 1}};
                 it.light.colorControl = ColorControl::SeparateSpecular;
                 it.view.projection = Projection::Orthographic;
                 it.passes[0].blend = true;
                 it.passes[0].blendDst = BlendFactor::OneMinusSrcColor;
             }},
        Case{"AlphaTested",
             [](Scene& it) {
                 it.textures[0].pattern = Pattern::Tree;
                 it.textures[0].internalFormat = InternalFormat::Alpha;
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
        Case{"HugeCoordinates", [](Scene& it) { scaleCoordinates(it, 3e18F); }},
        Case{"TheLargestCoordinates", [](Scene& it) { scaleCoordinates(it, 4e36F); }},
        Case{"HugeAnisotropicCoordinates",
             [](Scene& it) {
                 scaleCoordinates(it, 3e18F);
                 it.textures[0].maxAnisotropy = 16;
             }},
        Case{"TinyAnisotropicCoordinates",
             [](Scene& it) {
                 scaleCoordinates(it, 1e-20F);
                 it.textures[0].maxAnisotropy = 16;
             }},
        Case{"UnderTheNose", [](Scene& it) { it.view.distance = 1.2F; }},
        Case{"FarAway", [](Scene& it) { it.view.distance = 300; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Kernel, GivesTheBytesOfTheLiteralOneInEveryEnvironment) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = Pattern::Tree;
    scene.material.color = {0.9F, 0.7F, 0.5F, 0.8F};
    Unit& unit = scene.passes[0].units[0];
    unit.envColor = {0.3F, 0.6F, 0.9F, 0.5F};
    for (const EnumRow& mode : envModeRows) {
        for (const EnumRow& format : baseFormatRows) {
            SCOPED_TRACE(std::string(mode.name) + " " + std::string(format.name));
            unit.envMode = static_cast<EnvMode>(mode.value);
            scene.textures[0].internalFormat = static_cast<InternalFormat>(format.value);
            expectTheSame(scene);
        }
    }
}

TEST(Kernel, GivesTheBytesOfTheLiteralOneForEveryDepthFunction) {
    Scene scene = defaultScene();
    scene.models[1].position = scene.models[0].position; // they cut each other
    scene.passes.resize(2, scene.passes[0]);
    for (const EnumRow& row : compareFuncRows) {
        SCOPED_TRACE(row.name);
        scene.passes[1].depthFunc = static_cast<CompareFunc>(row.value);
        expectTheSame(scene);
    }
}

TEST(Kernel, GivesTheBytesOfTheLiteralOneForEveryBlendFactor) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = Pattern::Tree;
    scene.material.color = {0.9F, 0.7F, 0.5F, 0.8F};
    scene.view.background = {0.2F, 0.4F, 0.6F, 0.3F};
    Pass& pass = scene.passes[0];
    pass.lighting = false;
    pass.blend = true;
    for (const EnumRow& row : blendFactorRows) {
        SCOPED_TRACE(row.name);
        pass.blendSrc = static_cast<BlendFactor>(row.value);
        pass.blendDst = BlendFactor::OneMinusSrcAlpha;
        expectTheSame(scene);
        pass.blendDst = pass.blendSrc;
        pass.blendSrc = BlendFactor::DstAlpha;
        expectTheSame(scene);
    }
}

TEST(Kernel, GivesTheBytesOfTheLiteralOneWithOtherOptions) {
    for (Scene scene : {defaultScene(), floorScene()}) {
        scene.view.perspectiveHint = HintMode::Fastest;
        expectTheSame(scene);
        scene.passes[0].fog = {true, FogMode::Exp2, 0.1F, 0, 1, {0.4F, 0.5F, 0.6F, 1}};
        expectTheSame(scene);
        scene.view.perspectiveHint = HintMode::DontCare;
        for (const RhoMethod rho : {RhoMethod::Lower, RhoMethod::Upper}) {
            expectTheSame(scene, AnisotropyMethod::Probes, rho);
            EXPECT_NE(drawn(scene, {}, AnisotropyMethod::Probes, rho), drawn(scene, {}));
        }
        scene.textures[0].maxAnisotropy = 8;
        expectTheSame(scene, AnisotropyMethod::Ellipse);
    }
}

TEST(Kernel, DrawsTheSameWithAnyNumberOfThreads) {
    const Image one = drawn(defaultScene(), {.threads = 1});
    for (const unsigned threads : {2U, 5U, 16U})
        EXPECT_EQ(drawn(defaultScene(), {.threads = threads}), one) << threads << " threads";
}

TEST(Kernel, OfEveryLengthIsThereWhereTheProcessorHasIt) {
    ASSERT_FALSE(kernels().empty());
    EXPECT_EQ(kernels().back(), fourLanes());
    EXPECT_EQ(fourLanes()->lanes, 4);
#if defined(__x86_64__)
    EXPECT_EQ(eightLanes() != nullptr, __builtin_cpu_supports("avx2") != 0);
    EXPECT_EQ(kernels().size(), eightLanes() ? 2 : 1);
#endif
}

// More triangles than are set up at once: the depths of those before must be kept.
TEST(Kernel, KeepsTheDepthsFromBatchToBatch) {
    Scene scene = defaultScene();
    for (Model& model : scene.models) {
        model.shape = Shape::Sphere;
        model.slices = 128;
        model.stacks = 64;
    }
    scene.models[0].position = {0, 0, 0};
    scene.models[1].position = {0.4F, 0.2F, 0.3F}; // they cut each other
    scene.models.resize(2);
    scene.passes[0].depthFunc = CompareFunc::Less;
    const Image inOrder = drawn(scene, {});
    std::swap(scene.models[0], scene.models[1]);
    EXPECT_EQ(drawn(scene, {}), inOrder);
}

} // namespace
} // namespace texplorer::reference::kernel_test
