// The texts; probe_test.cpp tests their numbers.

#include "texplorer/reference/explain/explanation_steps.h"
#include "texplorer/reference/explain/sampling_steps.h"
#include "texplorer/reference/probe.h"

#include <gmock/gmock.h>

#include <limits>

namespace texplorer::reference::explanation_steps_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The full explanation of a pixel in the middle of a square.
std::string textOf(void (*change)(Scene& scene)) {
    Scene scene = defaultScene();
    scene.models.resize(1);
    scene.models[0] = Model{};
    scene.models[0].shape = Shape::Quad;
    scene.view = View{};
    change(scene);
    const Result<Explanation> found = probe({scene, {}, 0, 9, 9}, {4, 4});
    EXPECT_TRUE(found);
    std::string text;
    for (const FragmentSteps& fragment : stepsOf(found.value_or(Explanation{}))) {
        text += fragment.title.english() + ": " + fragment.outcome.english() + "\n";
        for (const Step& step : fragment.steps) {
            text += step.title.english() + ": " + step.summary.english() + "\n";
            for (const StepRow& row : step.rows) {
                text += row.label.english();
                for (const StepCell& cell : row.cells)
                    text += " | " + cell.text.english();
                text += "\n";
            }
        }
    }
    return text;
}

/// Two lines through the middle of the picture, or a point there, with colours of their own.
void showMesh(Scene& scene, Primitive primitive) {
    Model& model = scene.models[0];
    model.shape = Shape::Mesh;
    model.mesh.primitive = primitive;
    model.mesh.positions = {{-1, 0, 0}, {1, 0, 0}};
    model.mesh.colors = {{1, 0, 0, 1}, {0, 0, 1, 1}};
    if (primitive == Primitive::Points)
        model.mesh.positions.edit()[1].x = 0;
    scene.passes[0].lighting = false;
}

void showGradient(Scene& scene, InternalFormat format) {
    Texture& texture = scene.textures[0];
    texture.pattern = Pattern::Gradient;
    texture.minFilter = MinFilter::Nearest;
    texture.magFilter = MagFilter::Nearest;
    texture.internalFormat = format;
}

void showSeamlessCube(Scene& scene) {
    scene.passes[0].seamlessCubeMap = true;
    scene.passes[0].units[0].target = Target::CubeMap;
    scene.textures[0].minFilter = MinFilter::Linear;
}

/// The whole square has this s and t = 0.3, with 8 x 8 texels.
void showNearestAt(Scene& scene, float s, Wrap wrap) {
    Texture& texture = scene.textures[0];
    texture.minFilter = MinFilter::Nearest;
    texture.magFilter = MagFilter::Nearest;
    texture.baseLevel = 3;
    texture.wrapS = wrap;
    scene.models[0].texCoords[0] = TexCoords(4, {s, 0.3F, 0, 1});
}

/// Independent of the picture's size, by the bias.
void showLambda(Scene& scene, float lambda) {
    scene.passes[0].units[0].lodBias = 0;
    const Result<Explanation> found = probe({scene, {}, 0, 9, 9}, {4, 4});
    scene.passes[0].units[0].lodBias = lambda - found->fragments.at(0).units.at(0).sample.lod.base;
}

struct Case {
    const char* name;
    void (*change)(Scene& scene);
    const char* expected;
};
class Steps : public testing::TestWithParam<Case> {};
TEST_P(Steps, SayIt) {
    EXPECT_THAT(textOf(GetParam().change), HasSubstr(GetParam().expected));
}

INSTANTIATE_TEST_SUITE_P(
    All, Steps,
    testing::Values(
        Case{"Title", [](Scene&) {}, "Square, Front, triangle 1 (models[0], pass 0): drawn"},
        Case{"TitleOfALine", [](Scene& it) { showMesh(it, Primitive::Lines); },
             "Mesh, Line 1, line 0 (models[0], pass 0): drawn\nLine: 50 %, 50 %\nvertex | 0 | 1\n"},
        Case{"TitleOfAPoint", [](Scene& it) { showMesh(it, Primitive::Points); },
             "Mesh, Points, point 1 (models[0], pass 0): drawn\nPoint: 100 %\nvertex | 1\n"},
        Case{"ColorsOfVertices", [](Scene& it) { showMesh(it, Primitive::Lines); },
             "Lighting is off: the colours of the vertices, interpolated.\nvertex | 0 | 1\n"
             "colour | 1 0 0 1 | 0 0 1 1\n"},
        Case{"CoordinatesOfALine", [](Scene& it) { showMesh(it, Primitive::Lines); },
             "given | s | t | r | q\n  at vertex 0 | 0.0000 | 0.0000 | 0.0000 | 1.0000\n"
             "  at vertex 1 | 0.0000 | 0.0000 | 0.0000 | 1.0000\n  here"},
        Case{"Embossed", [](Scene& it) { it.passes[0].units[0].emboss.enabled = true; },
             "\nmoved towards the light | s | t | r | q\n  at vertex "},
        // glTranslatef and then glScalef: s becomes 2 s + 0.5.
        Case{"TextureMatrix",
             [](Scene& it) {
                 it.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}}};
                 it.models[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {2, 1, 1}}};
             },
             "1 step of the model\nthe texture matrix | s | t | r | q\n"
             "  s | 2.0000 | 0.0000 | 0.0000 | 0.5000\n  t | 0.0000 | 1.0000 | 0.0000 | 0.0000\n"
             "  r | 0.0000 | 0.0000 | 1.0000 | 0.0000\n  q | 0.0000 | 0.0000 | 0.0000 | 1.0000\n"
             "after the matrix"},
        Case{"Flat", [](Scene& it) { it.material.shadeModel = ShadeModel::Flat; }, "Flat shading"},
        Case{"Unlit", [](Scene& it) { it.passes[0].lighting = false; }, "Lighting is off"},
        Case{"Magnified", [](Scene& it) { it.passes[0].units[0].lodBias = -16; },
             "lambda is not above 0: the magnification filter decides, GL_LINEAR."},
        Case{"Minified", [](Scene& it) { it.passes[0].units[0].lodBias = 3; },
             "lambda is above 0: the minification filter decides, GL_LINEAR_MIPMAP_LINEAR."},
        Case{"SwitchOver",
             [](Scene& it) {
                 it.textures[0].minFilter = MinFilter::NearestMipmapLinear;
                 it.passes[0].units[0].lodBias = -16;
             },
             "lambda is not above 0.5 (as GL_LINEAR meets GL_NEAREST_MIPMAP_LINEAR)"},
        Case{"Clamped", [](Scene& it) { it.textures[0].minLod = 4; }, "clamped to 4 ... 1000 | 4"},
        // In the middle of the middle pixel of a square with 64 x 64 texels s is 0.5: where texel 32 begins.
        Case{"Linear", [](Scene& it) { it.textures[0].minFilter = MinFilter::Linear; },
             "0.5 → × 64 = 32\n | - 0.5 = 31.5: texel 31 and texel 32, shares 0.5 and 0.5"},
        Case{"Nearest",
             [](Scene& it) {
                 it.textures[0].minFilter = MinFilter::Nearest, it.textures[0].magFilter = MagFilter::Nearest;
             },
             "0.5 → × 64 = 32 → texel 32\n | on the edge of texel 32 and texel 31: either is correct"},
        // 3.99999 is not 4, even though it is printed with four digits.
        Case{
            "JustBelowATexel", [](Scene& it) { showNearestAt(it, 0.49999875F, Wrap::Repeat); },
            "0.49999875 → × 8 = 3.99999 → texel 3\n | on the edge of texel 3 and texel 4: either is correct"},
        Case{"TheOtherTexel", [](Scene& it) { showNearestAt(it, 0.49999875F, Wrap::Repeat); },
             "\n"
             "also correct: level 3 (4, 2)"},
        Case{"Repeated", [](Scene& it) { showNearestAt(it, 2.3F, Wrap::Repeat); },
             "s, GL_REPEAT | 2.3 → fraction 0.3 → × 8 = 2.4 → texel 2\n"},
        Case{"Mirrored", [](Scene& it) { showNearestAt(it, 1.7F, Wrap::MirroredRepeat); },
             "s, GL_MIRRORED_REPEAT | 1.7 → mirrored to 0.3 → × 8 = 2.4 → texel 2\n"},
        Case{"MirroredAtTheRim", [](Scene& it) { showNearestAt(it, 1.01F, Wrap::MirroredRepeat); },
             "s, GL_MIRRORED_REPEAT | 1.01 → mirrored to 0.99 → × 8 = 7.92, clamped to 7.5 → texel 7\n"},
        Case{"ClampedToTheEdge", [](Scene& it) { showNearestAt(it, 1.5179F, Wrap::ClampToEdge); },
             "s, GL_CLAMP_TO_EDGE | 1.5179 → clamped to 0.9375 → × 8 = 7.5 → texel 7\n"},
        Case{"ClampedToOne", [](Scene& it) { showNearestAt(it, 1.5179F, Wrap::Clamp); },
             "s, GL_CLAMP | 1.5179 → clamped to 1 → × 8 = 8 → last texel, 7\n"},
        Case{"ClampedToTheBorder", [](Scene& it) { showNearestAt(it, -0.5F, Wrap::ClampToBorder); },
             "s, GL_CLAMP_TO_BORDER | -0.5 → clamped to -0.0625 → × 8 = -0.5 → the border\n"},
        Case{"Inside", [](Scene& it) { showNearestAt(it, 0.3F, Wrap::ClampToEdge); },
             "s, GL_CLAMP_TO_EDGE | 0.3 → × 8 = 2.4 → texel 2\n"},
        Case{"HalfWayBetweenLevels",
             [](Scene& it) {
                 it.textures[0].minFilter = MinFilter::NearestMipmapNearest;
                 showLambda(it, 1.5F);
             },
             "lambda is half-way between level 1 and level 2, within 1/64: either is correct."},
        Case{"AboveC",
             [](Scene& it) {
                 it.textures[0].minFilter = MinFilter::NearestMipmapNearest;
                 showLambda(it, 0.50001F);
             },
             "Level of detail: lambda 0.5000"},
        // (0.5, 0.5, 0) is on the edge of +x and +y, half-way along it.
        Case{"Seamless", showSeamlessCube,
             "  t, seamless | 0 → × 64 = 0\n | - 0.5 = -0.5: the next face and texel 0, shares "
             "0.5 and 0.5"},
        Case{"AcrossTheEdge", showSeamlessCube, "\n+y (63, 31) across the edge | 0.2500"},
        Case{"LinearAcrossTheRim",
             [](Scene& it) {
                 it.textures[0].minFilter = MinFilter::Linear;
                 it.models[0].texCoords[0] = TexCoords(4, {0, 0, 0, 1});
             },
             "- 0.5 = -0.5: texel 63 and texel 0, shares 0.5 and 0.5"},
        Case{"LinearIntoTheBorder",
             [](Scene& it) {
                 it.textures[0].minFilter = MinFilter::Linear;
                 it.textures[0].wrapS = it.textures[0].wrapT = Wrap::Clamp;
                 it.models[0].texCoords[0] = TexCoords(4, {1, 1, 0, 1});
             },
             "- 0.5 = 63.5: texel 63 and the border, shares 0.5 and 0.5"},
        Case{
            "TooLong",
            [](Scene& it) {
                for (const float s : {0.0F, 1e30F})
                    it.models[0].texCoords[0].edit().insert(it.models[0].texCoords[0].end(), 2, {s, 0, 0, 1});
            },
            "log2(rho) | 103.6148"},
        Case{"Contradiction",
             [](Scene& it) {
                 it.textures[0].minLod = 4;
                 it.textures[0].maxLod = 2;
             },
             "undefined. The max LOD is used here."},
        Case{"Bias", [](Scene& it) { it.passes[0].units[0].lodBias = 1.5F; },
             "\n+ LOD bias of the unit | 1.5\n"},
        Case{"BiasOfTheTexture", [](Scene& it) { it.textures[0].lodBias = -2; },
             "\n+ LOD bias of the texture | -2\n"},
        Case{"BothBiases",
             [](Scene& it) {
                 it.textures[0].lodBias = 10;
                 it.passes[0].units[0].lodBias = 9;
             },
             "\n+ LOD bias of the texture | 10\n+ LOD bias of the unit | 9\ntogether clamped to | 16\n"},
        Case{"BiasBeyondTheLimit", [](Scene& it) { it.passes[0].units[0].lodBias = 90; },
             "\n+ LOD bias of the unit | 90\nclamped to | 16\n"},
        Case{"Generated",
             [](Scene& it) {
                 it.passes[0].units[0].texGenS.enabled = it.passes[0].units[0].texGenT.enabled = true;
             },
             "s, t are generated at each vertex."},
        Case{"NoQ",
             [](Scene& it) {
                 it.models[0].texCoords[0] = TexCoords(4, {1, 1, 0, 0});
             },
             "q is 0: the quotient is undefined."},
        Case{"Nan",
             [](Scene& it) {
                 it.models[0].texCoords[0] = TexCoords(4, glm::vec4(std::numeric_limits<float>::quiet_NaN()));
             },
             "A coordinate is infinite or not a number: undefined."},
        Case{"Decal",
             [](Scene& it) {
                 it.passes[0].units[0].envMode = EnvMode::Decal;
                 it.textures[0].internalFormat = InternalFormat::Luminance;
             },
             "GL_DECAL is undefined for GL_LUMINANCE: the incoming colour is passed on."},
        // In the middle of the gradient is texel (128, 128) with the colour (128, 128, 127): 7.53 and 7.47
        // of 15.
        Case{"FewBits", [](Scene& it) { showGradient(it, InternalFormat::Rgba4); },
             "\n  stored |  | 8/15 | 8/15 | 7/15 | 15/15\nGL_RGBA4 has few bits: "},
        Case{"AGreyOfFewBits", [](Scene& it) { showGradient(it, InternalFormat::Luminance4Alpha4); },
             "\n  stored |  | 8/15 | 8/15 | 8/15 | 15/15\n"},
        Case{"WhatAFormatDoesNotStore", [](Scene& it) { showGradient(it, InternalFormat::R3G3B2); },
             "\n  stored |  | 4/7 | 4/7 | 1/3 | -\n"},
        Case{"Srgb", [](Scene& it) { showGradient(it, InternalFormat::Srgb8); },
             "\n"
             "  stored |  | 128/255 | 128/255 | 127/255 | -\n"
             "GL_SRGB8 converts colours to light"},
        Case{"Prepared",
             [](Scene& it) {
                 it.textures[0].preparation = {{.op = ImageOp::Invert}, {.op = ImageOp::Sharpen}};
             },
             "\nThe image was prepared: Invert, Sharpen.\n"},
        Case{"Combine",
             [](Scene& it) {
                 it.passes[0].units[0].envMode = EnvMode::Combine;
                 it.passes[0].units[0].combine.source0Rgb = CombineSource::Texture3;
             },
             "Undefined: an argument is the texture of a unit without a texture."},
        Case{"Idle",
             [](Scene& it) { it.passes[0].units[2].enabled = true, it.passes[0].units[2].texture = 9; },
             "there is no textures[9]"},
        Case{"Fog",
             [](Scene& it) {
                 it.passes[0].lighting = false;
                 it.passes[0].units[0].enabled = false;
                 it.passes[0].fog = {true, FogMode::Linear, 1, 2, 10, {1, 0, 0, 1}};
             },
             "\nmode | GL_LINEAR\nc: distance from the eye's plane | 6\nf = (end - c) / (end - start)\n"
             "f | (10 - 6) / (10 - 2) = 0.5\nf, clamped | 0.5\nCr: before | 1 1 1 1\n"
             "Cf: fog colour | (1.0000, 0.0000, 0.0000)\nC = f * Cr + (1 - f) * Cf\n"
             "red | 0.5 * 1 + (1 - 0.5) * 1 = 1\ngreen | 0.5 * 1 + (1 - 0.5) * 0 = 0.5\n"},
        Case{"SeenFromTheFront", [](Scene& it) { it.light.twoSide = true; },
             "Seen from the front: lit with the normal."},
        Case{"SeenFromBehind",
             [](Scene& it) {
                 it.light.twoSide = true;
                 it.models[0].rotation = {0, 180, 0};
             },
             "Seen from behind: lit with the opposite normal (GL_LIGHT_MODEL_TWO_SIDE)."},
        Case{"SeenFromBehindAndLitAsTheFront",
             [](Scene& it) {
                 it.models[0].rotation = {0, 180, 0};
             },
             "Seen from behind, and lit as the front (GL_LIGHT_MODEL_TWO_SIDE is off)."},
        Case{"Specular", [](Scene& it) { it.light.colorControl = ColorControl::SeparateSpecular; },
             "Colour sum: "},
        Case{"Anisotropic",
             [](Scene& it) {
                 it.models[0].rotation = {80, 0, 0};
                 it.textures[0].maxAnisotropy = 4;
             },
             "anisotropic, up to 4: probes"},
        Case{"Alpha",
             [](Scene& it) {
                 it.passes[0].alphaTest = true;
                 it.passes[0].alphaFunc = CompareFunc::Never;
             },
             "failed: nothing is written"},
        Case{"Blended", [](Scene& it) { it.passes[0].blend = true; }, "  times GL_ZERO"},
        Case{"Clipped",
             [](Scene& it) {
                 it.view.distance = 0.1F, it.models[0].rotation = {85, 0, 0};
             },
             "was clipped"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(MergedTaps, AddUpWhatIsReadTwice) {
    SampleRecord sample;
    for (int i = 0; i < 12; ++i)
        sample.taps.push_back({.level = 1, .index = {i % 2, 0, 0}, .weight = i % 2 == 0 ? 0.1F : 0.05F});
    const std::vector<Tap> taps = mergedTaps(sample);
    ASSERT_EQ(taps.size(), 2U);
    EXPECT_EQ(taps[0].index.x, 0);
    EXPECT_FLOAT_EQ(taps[0].weight, 0.6F);
    EXPECT_FLOAT_EQ(taps[1].weight, 0.3F);
}

// Probes along a footprint read a texel several times, and border texels do not belong to the level.
TEST(TexelCount, CountsEveryTexelOnce) {
    SampleRecord sample;
    EXPECT_EQ(texelCount(sample), 0U);
    for (int i = 0; i < 4; ++i)
        sample.taps.push_back({.level = i / 2, .index = {3, 0, 0}, .weight = 0.25F});
    EXPECT_EQ(texelCount(sample), 2U) << "of two levels, also where few taps are listed one by one";
    sample.taps.push_back({.level = 0, .index = {-1, 0, 0}, .border = true});
    EXPECT_EQ(texelCount(sample), 3U);
}

TEST(NumberText, IsShort) {
    const auto texts = [](std::initializer_list<float> values) {
        std::vector<std::string> all;
        for (const float value : values)
            all.push_back(numberText(value));
        return all;
    };
    EXPECT_THAT(
        texts({0, 1, -2.5F, 0.333333F, 0.00012345F, 3e38F, -1e-30F, std::numeric_limits<float>::infinity()}),
        ElementsAre("0", "1", "-2.5", "0.3333", "0.0001", "3e+38", "0", "inf"));
    EXPECT_EQ(amountText(1.4e-6F), "< 0.0001");
    EXPECT_EQ(amountText(-4.31e-7F), "> -0.0001");
    EXPECT_EQ(amountText(0), "0");
    EXPECT_EQ(amountText(0.25F), "0.25");
}

TEST(ColumnText, HasTheSameDigitsInEachLine) {
    EXPECT_EQ(columnText(0.5F), "0.5000");
    EXPECT_EQ(columnText(-12.25F), "-12.2500");
    EXPECT_EQ(columnText(-4.31e-7F), "0.0000");
    EXPECT_EQ(columnText(0.0021306F, 6), "0.002131");
    EXPECT_EQ(columnText(3e38F), "3e+38");
    EXPECT_EQ(columnText(std::numeric_limits<float>::infinity()), "inf");
}

} // namespace
} // namespace texplorer::reference::explanation_steps_test
