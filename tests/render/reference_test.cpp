// The reference renderer against OpenGL: two implementations of one specification without common code. The
// tolerances allow for precision: a driver may round coordinates, filter weights and lambda.

#include "tests/support/flat_scene.h"
#include "tests/support/floor_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/param_text.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

namespace texplorer::reference_test {
namespace {

using namespace test;

struct Difference {
    std::size_t pixels = 0;
    std::size_t above = 0; ///< with a component that differs by more than the tolerance
    int worst = 0;
    double share() const { return static_cast<double>(above) / static_cast<double>(pixels); }
};

Difference differenceOf(const Image& a, const Image& b, int tolerance) {
    Difference difference;
    difference.pixels = a.pixels.size() / 4;
    for (std::size_t i = 0; i + 3 < a.pixels.size() && i + 3 < b.pixels.size(); i += 4) {
        int worst = 0;
        for (std::size_t c = i; c < i + 4; ++c)
            worst = std::max(worst,
                             std::abs(std::to_integer<int>(a.pixels[c]) - std::to_integer<int>(b.pixels[c])));
        difference.worst = std::max(difference.worst, worst);
        difference.above += worst > tolerance ? 1 : 0;
    }
    return difference;
}

class Reference : public RenderTest {
protected:
    /// At most this share of the pixels may differ by more than `tolerance` 255ths.
    void agree(const Scene& scene, double share, int tolerance = 2, int extent = 96,
               reference::AnisotropyMethod method = reference::AnisotropyMethod::Probes) {
        const Image theirs = picture(scene, extent, 0.5);
        const Result<Frame> ours = reference::drawReference({scene, images, 0.5, extent, extent, method});
        ASSERT_TRUE(ours) << describe(ours.error());
        EXPECT_EQ(ours->problems, problems);
        ASSERT_EQ(theirs.pixels.size(), ours->image.pixels.size());
        const Difference difference = differenceOf(theirs, ours->image, tolerance);
        EXPECT_LE(difference.share(), share) << difference.above << " of " << difference.pixels
                                             << " pixels, the worst by " << difference.worst;
    }

    /// Unlit and without a depth test: only texels.
    Scene floorScene() {
        Scene scene = test::floorScene();
        scene.passes[0].depthTest = false;
        scene.passes[0].units[0].envMode = EnvMode::Replace;
        return scene;
    }
};

// --- Covered pixels

TEST_F(Reference, CoversTheSamePixels) {
    Scene scene = flatScene();
    scene.material.color = {1, 0.5F, 0.25F, 1};
    for (const float turn : {0.0F, 10.0F, 33.0F, 45.0F, 90.0F}) {
        scene.models[0].rotation = {0, 0, turn};
        scene.models[0].size = 0.77F;
        agree(scene, 0, 0);
    }
}

TEST_F(Reference, CoversPixelsOnAnEdgeOnce) {
    Scene scene = flatScene();
    scene.passes[0].blend = true;
    scene.passes[0].blendDst = BlendFactor::One;
    scene.material.color = {0.25F, 0.25F, 0.25F, 0.25F};
    scene.models[0].size = 0.75F; // its edges run through pixel centres of a picture of 12 x 12
    for (const int extent : {12, 16, 20, 24})
        agree(scene, 0, 0, extent);
}

// --- The floor's colour

TEST_F(Reference, MixesTheSameFog) {
    for (const EnumRow& mode : fogModeRows) {
        SCOPED_TRACE(mode.name);
        for (Scene scene : {defaultScene(), floorScene()}) {
            scene.passes[0].units[0].enabled = false;
            scene.light.colorControl = ColorControl::SeparateSpecular;
            scene.view.distance = 2; // the near plane cuts the floor
            scene.passes[0].fog = {true, static_cast<FogMode>(mode.value), 0.2F, 1, 9, {0.4F, 0.5F, 0.6F, 1}};
            agree(scene, 0.001, 1);
            scene.view.projection = Projection::Orthographic;
            agree(scene, 0.001, 1);
        }
    }
}

TEST_F(Reference, InterpolatesFogWithoutPerspectiveAsTheShadersDo) {
    if (testedRenderer() == RendererKind::Fixed)
        GTEST_SKIP() << "fixed function may ignore the hint";
    for (const ShadeModel shading : {ShadeModel::Smooth, ShadeModel::Flat}) {
        Scene scene = floorScene();
        scene.passes[0].units[0].enabled = false;
        scene.material.shadeModel = shading;
        scene.passes[0].fog = {true, FogMode::Linear, 1, 2, 60, {0.4F, 0.5F, 0.6F, 1}};
        const Image corrected = picture(scene, 96);
        scene.view.perspectiveHint = HintMode::Fastest;
        EXPECT_NE(picture(scene, 96), corrected);
        agree(scene, 0.001, 1);
    }
}

TEST_F(Reference, LightsTheSameSides) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].enabled = false;
    scene.light.twoSide = true;
    scene.light.position = {0.5F, 1, 2, 1};
    scene.models.resize(1);
    scene.models[0].texCoords = {};
    for (const Shape shape : {Shape::Cylinder, Shape::PartialDisk, Shape::Quad, Shape::Torus}) {
        for (const float turn : {20.0F, 110.0F, 200.0F, 290.0F}) {
            SCOPED_TRACE(rowOf(shape).name);
            scene.models[0].shape = shape;
            scene.models[0].rotation = {turn, turn / 2, 0};
            for (const ShadeModel shading : {ShadeModel::Smooth, ShadeModel::Flat}) {
                scene.material.shadeModel = shading;
                agree(scene, 0.002, 1);
            }
        }
    }
}

TEST_F(Reference, ClipsAtTheNearPlane) {
    Scene scene = floorScene();
    scene.passes[0].units[0].enabled = false;
    scene.view.distance = 2;
    scene.view.target = {0, -0.9F, -3};
    agree(scene, 0.001, 0);
}

TEST_F(Reference, HidesWhatLiesBehind) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].enabled = false;
    scene.models[1].position = {-0.7F, 0.1F, 0.4F};
    agree(scene, 0.002, 1);
}

// --- Colours

struct Colors {
    const char* name;
    ColorControl control;
    ShadeModel shade;
    bool localViewer;
};
class ReferenceLighting : public Reference, public testing::WithParamInterface<Colors> {};

TEST_P(ReferenceLighting, GivesTheSameColors) {
    Scene scene = defaultScene();
    scene.textures[0].mipmaps = MipPolicy::None;
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].minFilter = MinFilter::Nearest;
    scene.light.colorControl = GetParam().control;
    scene.light.localViewer = GetParam().localViewer;
    scene.material.shadeModel = GetParam().shade;
    scene.material.color = {0.8F, 0.5F, 0.3F, 0.7F};
    scene.models[0].spin = {10, 20, 30};
    agree(scene, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    All, ReferenceLighting,
    testing::Values(Colors{"Single", ColorControl::Single, ShadeModel::Smooth, false},
                    Colors{"Separate", ColorControl::SeparateSpecular, ShadeModel::Smooth, false},
                    Colors{"LocalViewer", ColorControl::SeparateSpecular, ShadeModel::Smooth, true},
                    Colors{"Flat", ColorControl::SeparateSpecular, ShadeModel::Flat, false}),
    [](const auto& test) { return std::string(test.param.name); });

// Exact, except for the rounding to the driver's eight bits.
TEST_F(Reference, AgreesOnEveryEnvironmentAndBaseFormat) {
    images.put("image", plainImage(1, 1, {153, 51, 204, 102}));
    Scene scene = texturedScene();
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.passes[0].units[0].envColor = {0.4F, 0.8F, 0.2F, 0.6F};
    for (const EnumRow& mode : envModeRows) {
        if (static_cast<EnvMode>(mode.value) == EnvMode::Combine)
            continue; // see below
        for (const EnumRow& format : baseFormatRows) {
            SCOPED_TRACE(std::string(mode.name) + " " + std::string(format.name));
            scene.passes[0].units[0].envMode = static_cast<EnvMode>(mode.value);
            scene.textures[0].internalFormat = static_cast<InternalFormat>(format.value);
            agree(scene, 0, 1, 4);
        }
    }
}

TEST_F(Reference, AgreesOnEveryWrapModeOnFlatQuads) {
    images.put("image",
               rgbaImage(2, 2, 1, {{255, 0, 0, 255}, {0, 255, 0, 51}, {0, 0, 255, 102}, {255, 255, 0, 204}}));
    Scene scene = texturedScene();
    scene.textures[0].borderColor = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.models[0].texCoords[0] = quadCoords({-1.53F, -1.31F, 0, 1}, {2.61F, 2.37F, 0, 1});
    for (const EnumRow& s : wrapRows) {
        for (const EnumRow& t : wrapRows) {
            SCOPED_TRACE(std::string(s.name) + " " + std::string(t.name));
            scene.textures[0].wrapS = static_cast<Wrap>(s.value);
            scene.textures[0].wrapT = static_cast<Wrap>(t.value);
            agree(scene, 0, 1, 64);
        }
    }
}

TEST_F(Reference, BlendsTwoPassesAndTestsAlpha) {
    Scene scene = defaultScene();
    scene.textures[0].internalFormat = InternalFormat::Alpha;
    scene.textures[0].pattern = Pattern::Tree;
    scene.textures[0].minFilter = MinFilter::Nearest;
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.passes.resize(2);
    scene.passes[1] = scene.passes[0];
    scene.passes[0].alphaTest = true;
    scene.passes[0].alphaFunc = CompareFunc::Greater;
    scene.passes[0].alphaRef = 0.5F;
    scene.passes[1].depthFunc = CompareFunc::LessEqual;
    scene.passes[1].blend = true;
    scene.passes[1].blendSrc = BlendFactor::OneMinusDstColor;
    scene.passes[1].blendDst = BlendFactor::SrcColor;
    agree(scene, 0.01);
}

TEST_F(Reference, AppliesTwoUnitsOneAfterTheOther) {
    Scene scene = defaultScene();
    scene.textures.resize(2);
    scene.textures[1].pattern = Pattern::ColorLine;
    for (Texture& texture : scene.textures) {
        texture.mipmaps = MipPolicy::None;
        texture.minFilter = MinFilter::Linear;
    }
    Unit& second = scene.passes[0].units[2];
    second.enabled = true;
    second.texture = 1;
    second.envMode = EnvMode::Add;
    second.matrix = {{.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angleRate = 60},
                     {.op = MatrixOp::Scale, .amount = {2, 3, 1}}};
    agree(scene, 0.01);
}

// Every function, and every source and operand of the first argument, and every scale, for both halves.
TEST_F(Reference, AgreesOnCombine) {
    images.put("image", plainImage(1, 1, {153, 51, 204, 102}));
    images.put("other", plainImage(1, 1, {64, 128, 191, 230}));
    Scene scene = texturedScene();
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.textures.push_back(scene.textures[0]);
    scene.textures[1].file = "other";
    Pass& pass = scene.passes[0];
    pass.units.fill(pass.units[0]); // all four are on, so that the crossbar finds each
    pass.units[2].texture = 1;
    Unit& unit = pass.units[1];
    unit.envMode = EnvMode::Combine;
    unit.envColor = {0.4F, 0.8F, 0.2F, 0.6F};
    for (const std::size_t last : {2U, 3U}) { // these two pass on what unit 1 made
        pass.units[last].envMode = EnvMode::Combine;
        pass.units[last].combine = {.rgb = CombineRgb::Replace,
                                    .source0Rgb = CombineSource::Previous,
                                    .alpha = CombineAlpha::Replace,
                                    .source0Alpha = CombineSource::Previous};
    }
    for (const EnumRow& function : combineRgbRows) {
        SCOPED_TRACE(function.name);
        unit.combine = {.rgb = static_cast<CombineRgb>(function.value)};
        if (findRow(combineAlphaRows, function.value))
            unit.combine.alpha = static_cast<CombineAlpha>(function.value);
        agree(scene, 0, 2, 2);
    }
    unit.combine = {};
    for (const EnumRow& source : combineSourceRows) {
        SCOPED_TRACE(source.name);
        unit.combine.source0Rgb = unit.combine.source0Alpha = static_cast<CombineSource>(source.value);
        agree(scene, 0, 2, 2);
    }
    for (const EnumRow& operand : operandRgbRows) {
        SCOPED_TRACE(operand.name);
        unit.combine.operand0Rgb = static_cast<OperandRgb>(operand.value);
        if (findRow(operandAlphaRows, operand.value))
            unit.combine.operand0Alpha = static_cast<OperandAlpha>(operand.value);
        agree(scene, 0, 2, 2);
    }
    for (const EnumRow& scale : combineScaleRows) {
        SCOPED_TRACE(scale.name);
        unit.combine.rgbScale = unit.combine.alphaScale = static_cast<CombineScale>(scale.value);
        agree(scene, 0, 4, 2); // the driver's rounding is scaled, too
    }
}

TEST_F(Reference, GeneratesTheSameCoordinates) {
    Scene scene = defaultScene();
    scene.textures[0].minFilter = MinFilter::Linear;
    scene.models[0].rotation = {20, 40, 60};
    Unit& unit = scene.passes[0].units[0];
    unit.texGenS.eyePlane = unit.texGenS.objectPlane = {0.5F, 0.25F, -0.3F, 0.1F};
    unit.texGenT.eyePlane = unit.texGenT.objectPlane = {-0.2F, 0.6F, 0.4F, 0.3F};
    unit.texGenS.enabled = unit.texGenT.enabled = true;
    for (const EnumRow& mode : texGenModeRows) {
        SCOPED_TRACE(mode.name);
        unit.texGenS.mode = unit.texGenT.mode = static_cast<TexGenMode>(mode.value);
        agree(scene, 0.01);
    }
}

// The hint is for fixed functions, and Mesa ignores it; the shaders interpolate as the reference does.
TEST_F(Reference, InterpolatesWithoutPerspectiveAsTheShadersDo) {
    Scene scene = texturedScene();
    images.put("image",
               rgbaImage(2, 2, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {9, 99, 199, 255}}));
    scene.view.projection = Projection::Perspective;
    scene.view.distance = 2;
    scene.models[0].rotation = {50, 20, 0};
    scene.models[0].position.x = 1; // partly outside of the view
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {5, 7, 0, 1});
    agree(scene, 0.005);
    scene.view.perspectiveHint = HintMode::Fastest;
    if (testedRenderer() == RendererKind::Shader) {
        agree(scene, 0.005);
        Scene floor = floorScene(); // much of it outside of the view
        floor.view.perspectiveHint = HintMode::Fastest;
        floor.textures[0].minFilter = MinFilter::Nearest;
        floor.textures[0].magFilter = MagFilter::Nearest;
        agree(floor, 0.01);
    } else {
        const Image hinted = picture(scene, 96);
        scene.view.perspectiveHint = HintMode::Nicest;
        EXPECT_EQ(picture(scene, 96), hinted);
    }
}

TEST_F(Reference, InterpolatesColoursWithoutPerspectiveAsTheShadersDo) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].enabled = false;
    scene.models.erase(scene.models.begin());
    scene.models[0].slices = 4;
    scene.models[0].stacks = 2;
    scene.view.fieldOfView = 120;
    scene.view.distance = 1.8F;
    scene.view.perspectiveHint = HintMode::Fastest;
    scene.models[0].position.x = 0.4F; // partly outside of the view
    for (const ColorControl control : {ColorControl::Single, ColorControl::SeparateSpecular}) {
        scene.light.colorControl = control;
        if (testedRenderer() == RendererKind::Shader)
            agree(scene, 0.005);
    }
}

// If the driver removes the border, the inside and the border colour must be the same.
TEST_F(Reference, DrawsTheInsideOfAnImageWithABorderAlike) {
    Image framed = Image::uninitialised(PixelFormat::Rgba8, 10, 10);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            const bool border = x == 0 || y == 0 || x == 9 || y == 9;
            const auto texel = framed.at(x, y);
            texel[0] = static_cast<std::byte>(border ? 255 : 20 * x);
            texel[1] = static_cast<std::byte>(border ? 255 : 20 * y);
            texel[2] = static_cast<std::byte>(border ? 255 : 50);
            texel[3] = std::byte{255};
        }
    }
    images.put("image", framed);
    Scene scene = texturedScene();
    scene.textures[0].border = 1;
    scene.textures[0].mipmaps = MipPolicy::Generated;
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {1, 1, 0, 1});
    for (const MinFilter filter : {MinFilter::Nearest, MinFilter::LinearMipmapNearest}) {
        scene.textures[0].minFilter = filter;
        agree(scene, 0, 1, 64);
        agree(scene, 0, 1, 2);
    }
    // Outside the reference shows white texels, Mesa the border colour.
    scene.textures[0].wrapS = scene.textures[0].wrapT = Wrap::ClampToBorder;
    scene.textures[0].borderColor = {0.2F, 0.4F, 0.6F, 1};
    scene.models[0].texCoords[0] = quadCoords({3, 3, 0, 1});
    const Result<Frame> ours = reference::drawReference({scene, images, 0, 8, 8});
    ASSERT_TRUE(ours);
    EXPECT_TRUE(isColor(colorAt(ours->image, 4, 4), glm::vec4(1), 0));
    if (!capabilities.textureBorders) {
        EXPECT_TRUE(isColor(onlyColor(scene), {0.2F, 0.4F, 0.6F, 1}));
    }
}

// --- Filters

struct Filter {
    const char* name;
    MagFilter mag;
    MinFilter min;
    double share; ///< of pixels that may differ
};
class ReferenceFilter : public Reference, public testing::WithParamInterface<Filter> {};

TEST_P(ReferenceFilter, FiltersTheFloorAlike) {
    Scene scene = floorScene();
    scene.textures[0].magFilter = GetParam().mag;
    scene.textures[0].minFilter = GetParam().min;
    agree(scene, GetParam().share, 2, 256);
}

INSTANTIATE_TEST_SUITE_P(
    All, ReferenceFilter,
    testing::Values(Filter{"Nearest", MagFilter::Nearest, MinFilter::Nearest, 0.001},
                    Filter{"Linear", MagFilter::Linear, MinFilter::Linear, 0.001},
                    // Magnification is nearest: llvmpipe always takes 0 for the switch-over c.
                    Filter{"NearestMipmapNearest", MagFilter::Nearest, MinFilter::NearestMipmapNearest,
                           0.005},
                    Filter{"LinearMipmapNearest", MagFilter::Linear, MinFilter::LinearMipmapNearest, 0.005}),
    [](const auto& test) { return std::string(test.param.name); });

// Between two levels the colour shows lambda. llvmpipe computes log2(rho) = log2(rho^2) / 2 from a float's
// exponent and mantissa m as e + (m - 1), which is at most 0.0861 / 2 too small, and takes the derivatives
// from whole blocks of 2 x 2 pixels, half a pixel away. Its colour must be between those of the reference for
// that range of lambda.
constexpr float minError = -0.0431F - 0.02F;
constexpr float maxError = 0.02F;

class ReferenceTrilinear : public Reference, public testing::WithParamInterface<Filter> {};

TEST_P(ReferenceTrilinear, LiesBetweenTheBoundsOfLambda) {
    Scene scene = floorScene();
    scene.textures[0].magFilter = GetParam().mag;
    scene.textures[0].minFilter = GetParam().min;
    const Image theirs = picture(scene, 256);
    std::vector<Image> ours;
    for (const float bias : {minError, minError / 2, 0.0F, maxError}) {
        scene.passes[0].units[0].lodBias = bias;
        Result<Frame> drawn = reference::drawReference({scene, images, 0, 256, 256});
        ASSERT_TRUE(drawn);
        ours.push_back(std::move(drawn->image));
    }
    constexpr int tolerance = 2;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < theirs.pixels.size(); i += 4) {
        bool within = true;
        for (std::size_t c = i; c < i + 4; ++c) {
            const auto value = [c](const Image& image) { return std::to_integer<int>(image.pixels[c]); };
            int low = 255;
            int high = 0;
            for (const Image& each : ours) {
                low = std::min(low, value(each));
                high = std::max(high, value(each));
            }
            within = within && value(theirs) >= low - tolerance && value(theirs) <= high + tolerance;
        }
        outside += within ? 0 : 1;
    }
    EXPECT_LE(static_cast<double>(outside), GetParam().share * 256 * 256);
}

INSTANTIATE_TEST_SUITE_P(
    All, ReferenceTrilinear,
    testing::Values(Filter{"NearestMipmapLinear", MagFilter::Nearest, MinFilter::NearestMipmapLinear, 0.01},
                    Filter{"LinearMipmapLinear", MagFilter::Linear, MinFilter::LinearMipmapLinear, 0.01}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(Reference, FiltersAnisotropicallyAsLlvmpipeWhateverTheFilters) {
    for (const MinFilter filter : {MinFilter::NearestMipmapNearest, MinFilter::LinearMipmapNearest,
                                   MinFilter::NearestMipmapLinear, MinFilter::LinearMipmapLinear}) {
        SCOPED_TRACE(rowOf(filter).name);
        Scene scene = floorScene();
        scene.textures[0].minFilter = filter;
        for (const float limit : {8.0F, 16.0F}) {
            scene.textures[0].maxAnisotropy = limit;
            agree(scene, 0.01, 6, 256, anisotropy());
        }
    }
}

TEST_F(Reference, DrawsAnIncompleteTextureAsNone) {
    Scene scene = texturedScene();
    images.put("image", plainImage(4, 4, {255, 0, 0, 255}));
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    scene.textures[0].minFilter = MinFilter::NearestMipmapLinear;
    agree(scene, 0, 1, 4);
}

TEST_F(Reference, SaysWhatIsMissingInTheSameWords) {
    Scene scene = texturedScene();
    agree(scene, 0, 1, 4);
    EXPECT_THAT(problems, testing::SizeIs(1));
    scene.passes[0].units[0].texture = 5;
    agree(scene, 0, 1, 4);
}

} // namespace
} // namespace texplorer::reference_test
