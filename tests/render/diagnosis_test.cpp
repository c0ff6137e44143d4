// The diagnosis against the driver: what it calls incomplete is drawn as if the unit were off, and what it
// says has no effect changes no pixel when it is set to something else.

#include "app/view/driver_facts.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/params/params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace texplorer::diagnosis_test {
namespace {

using namespace test;

constexpr glm::vec4 red{1, 0, 0, 1};
constexpr glm::vec4 untextured{0.2F, 0.4F, 0.6F, 0.8F};

struct Case {
    const char* name;
    bool complete;
    void (*edit)(Texture& texture);
};

void PrintTo(const Case& each, std::ostream* out) {
    *out << each.name;
}

class CompletenessOnTheDriver : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(CompletenessOnTheDriver, IsAsTheDiagnosisSays) {
    TextureImage file;
    file.levels = 2;
    file.surfaces = {plainImage(16, 16, {255, 0, 0, 255}), plainImage(8, 8, {255, 0, 0, 255})};
    images.put("image", std::move(file));
    Scene scene = texturedScene();
    scene.material.color = untextured;
    GetParam().edit(scene.textures[0]);
    bool found = false;
    for (const Finding& each : diagnose(scene, images))
        found |= each.rule == "incomplete";
    EXPECT_EQ(found, !GetParam().complete);
    EXPECT_TRUE(isColor(onlyColor(scene), GetParam().complete ? red : untextured));
}

INSTANTIATE_TEST_SUITE_P(
    All, CompletenessOnTheDriver,
    testing::Values(
        Case{"BaseAlone", true, [](Texture&) {}},
        Case{"NoMipmaps", false, [](Texture& x) { x.minFilter = MinFilter::NearestMipmapNearest; }},
        Case{"NoMipmapsTrilinear", false, [](Texture& x) { x.minFilter = MinFilter::LinearMipmapLinear; }},
        Case{"Generated", true,
             [](Texture& x) {
                 x.minFilter = MinFilter::LinearMipmapLinear;
                 x.mipmaps = MipPolicy::Generated;
             }},
        Case{"OneMissing", false,
             [](Texture& x) {
                 x.minFilter = MinFilter::LinearMipmapNearest;
                 x.mipmaps = MipPolicy::Missing;
             }},
        Case{"OneMissingUnread", true, [](Texture& x) { x.mipmaps = MipPolicy::Missing; }},
        Case{"MissingBeyondMaxLevel", true,
             [](Texture& x) {
                 x.minFilter = MinFilter::LinearMipmapNearest;
                 x.mipmaps = MipPolicy::Missing;
                 x.maxLevel = 1;
             }},
        Case{"MissingBelowBaseLevel", true,
             [](Texture& x) {
                 x.minFilter = MinFilter::LinearMipmapNearest;
                 x.mipmaps = MipPolicy::Missing;
                 x.baseLevel = 3;
             }},
        // Without mipmaps section 3.8.8 reads the base level, wherever the maximal level is.
        Case{"MaxBelowBaseWithoutMipmaps", true,
             [](Texture& x) {
                 x.mipmaps = MipPolicy::FromFile;
                 x.baseLevel = 1;
                 x.maxLevel = 0;
             }},
        Case{"BaseFarBeyond", false, [](Texture& x) { x.baseLevel = 322; }},
        Case{"BaseBeyondTheFile", false,
             [](Texture& x) {
                 x.mipmaps = MipPolicy::FromFile;
                 x.baseLevel = 2;
             }},
        Case{"ShortFile", true,
             [](Texture& x) {
                 x.minFilter = MinFilter::LinearMipmapLinear;
                 x.mipmaps = MipPolicy::FromFile;
             }},
        Case{"BaseLevelMissing", false, [](Texture& x) { x.baseLevel = 1; }},
        Case{"BaseBeyondTheChain", false,
             [](Texture& x) {
                 x.mipmaps = MipPolicy::Generated;
                 x.minFilter = MinFilter::LinearMipmapLinear;
                 x.baseLevel = 5;
             }},
        Case{"BaseAboveMax", false,
             [](Texture& x) {
                 x.mipmaps = MipPolicy::Generated;
                 x.minFilter = MinFilter::LinearMipmapLinear;
                 x.baseLevel = 2;
                 x.maxLevel = 1;
             }}),
    [](const auto& test) { return std::string(test.param.name); });

/// Another value that the row accepts, far from the present one.
Value otherThan(const ParamRow& row, const Value& value) {
    Value other = value;
    if (bool* flag = std::get_if<bool>(&other))
        *flag = !*flag;
    else if (int* whole = std::get_if<int>(&other))
        *whole = *whole == 3 ? 2 : std::min(3, static_cast<int>(row.range.max));
    else if (float* number = std::get_if<float>(&other))
        *number = *number == row.range.max ? row.range.min : row.range.max;
    else if (auto* vector = std::get_if<glm::vec4>(&other))
        *vector = glm::vec4(1) - *vector;
    else if (auto* choice = std::get_if<EnumValue>(&other)) {
        for (const EnumRow& each : row.choices) {
            const bool ofDepths = row.member == memberId<&Texture::internalFormat> &&
                                  isDepth(static_cast<InternalFormat>(each.value)); // which end compression
            if (each.value != choice->number && !ofDepths)
                choice->number = each.value; // the last one
        }
    }
    return other;
}

class EffectOnTheDriver : public RenderTest {};

/// Scenes that differ in what decides whether settings matter.
std::vector<Scene> variants() {
    std::vector<Scene> scenes(19, defaultScene());
    for (Scene& scene : scenes) {
        scene.view.background = {0.2F, 0.1F, 0.3F, 1};
        scene.textures[0].pattern = Pattern::UvTemplate;
        scene.models[0].texCoords[0].clear();
        scene.passes[0].units[0].matrix = {{MatrixOp::Scale, {3, 3, 3}}};
    }
    scenes[1].textures[0].minFilter = MinFilter::Nearest;
    scenes[1].textures[0].magFilter = MagFilter::Nearest;
    scenes[1].textures[0].wrapS = Wrap::Clamp;
    scenes[2].passes[0].units[0].target = Target::Texture1D;
    scenes[2].textures[0].minFilter = MinFilter::Linear;
    scenes[3].passes[0].lighting = false;
    scenes[3].passes[0].blend = true;
    scenes[4].material.specular = {0, 0, 0, 1};
    scenes[4].passes[0].units[0].envMode = EnvMode::Combine;
    scenes[4].passes[0].units[0].combine.rgb = CombineRgb::Replace;
    scenes[5].passes[0].units[0].envMode = EnvMode::Combine;
    scenes[5].passes[0].units[0].combine.rgb = CombineRgb::Dot3Rgba;
    scenes[5].passes[0].alphaTest = true;
    scenes[6].passes[0].units[0].texGenS.enabled = true;
    scenes[6].passes[0].units[0].texGenT.enabled = true;
    scenes[6].passes[0].units[0].texGenT.mode = TexGenMode::SphereMap;
    scenes[7].textures[0].compression = Compression::Driver;
    scenes[7].light.specular = {0, 0, 0, 1};
    scenes[7].passes[0].units[1] = scenes[7].passes[0].units[0];
    scenes[7].passes[0].units[1].envMode = EnvMode::Replace;
    scenes[8].textures[0].pattern = Pattern::CubeFaces;
    scenes[8].textures[0].wrapS = scenes[8].textures[0].wrapT = Wrap::ClampToEdge;
    scenes[8].passes[0].units[0].target = Target::CubeMap;
    for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR}) {
        (scenes[8].passes[0].units[0].*each).enabled = true;
        (scenes[8].passes[0].units[0].*each).mode = TexGenMode::NormalMap;
    }
    scenes[9].textures[0].border = 1;
    scenes[10].passes[0].units[0].enabled = false;
    for (std::size_t each = 11; each <= 14; ++each)
        scenes[each].passes[0].units[0].envMode = EnvMode::Replace;
    scenes[12].light.colorControl = ColorControl::SeparateSpecular;
    scenes[13].light.colorControl = ColorControl::SeparateSpecular;
    scenes[13].light.specular = {0, 0, 0, 1};
    scenes[14].textures[0].internalFormat = InternalFormat::Luminance;
    scenes[14].passes[0].lighting = false;
    scenes[15].models[0].visible = false;
    scenes[15].models[0].shape = Shape::Sphere;
    scenes[16].passes[0].units[1] = scenes[16].passes[0].units[0];
    scenes[16].passes[0].units[1].texture = 1;
    scenes[16].passes[0].units[1].envMode = EnvMode::Replace;
    scenes[16].textures.push_back(scenes[16].textures[0]);
    scenes[16].textures[1].pattern = Pattern::Brick;
    scenes.push_back(scenes[8]);
    scenes.back().passes[0].seamlessCubeMap = true;
    scenes.back().textures[0].wrapS = Wrap::Repeat;
    scenes.back().textures[0].wrapT = Wrap::ClampToBorder;
    scenes.push_back(scenes[8]);
    scenes.back().textures[0].minFilter = MinFilter::Nearest;
    scenes.back().textures[0].magFilter = MagFilter::Nearest;
    Scene shadows = defaultScene();
    shadows.textures[0].source = SourceKind::LightDepth;
    shadows.textures[0].mipmaps = MipPolicy::None;
    shadows.textures[0].internalFormat = InternalFormat::DepthComponent24;
    shadows.textures[0].minFilter = MinFilter::Linear;
    shadows.textures[0].compareMode = CompareMode::RToTexture;
    shadows.passes[0].lighting = false; // the light counts all the same
    shadows.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -0.01F}},
                                         {.op = MatrixOp::Projector}};
    int axis = 0;
    for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR, &Unit::texGenQ}) {
        TexGen& generated = shadows.passes[0].units[0].*each;
        generated.enabled = true;
        generated.eyePlane = glm::vec4(0);
        generated.eyePlane[axis++] = 1;
    }
    scenes.push_back(shadows);
    scenes.back().textures[0].compareMode = CompareMode::None;
    scenes.back().textures[0].magFilter = MagFilter::Nearest;
    scenes.back().textures[0].preparation = {{.op = ImageOp::Scale}, {.op = ImageOp::Invert}};
    scenes.push_back(shadows);
    scenes[17].passes[0].fog = {true, FogMode::Exp, 0.1F, 0, 1, {0.2F, 0.1F, 0.3F, 1}};
    scenes[18].passes[0].fog = {true, FogMode::Linear, 0.1F, 2, 9, {0.2F, 0.1F, 0.3F, 1}};
    return scenes;
}

TEST_F(EffectOnTheDriver, WhatHasNoneChangesNoPixel) {
    std::set<std::string> tried;
    std::size_t number = 0;
    for (const Scene& scene : variants()) {
        const Image before = picture(scene, 96);
        EXPECT_TRUE(problems.empty());
        const std::vector<Finding> findings = diagnose(scene, images, view::driverFacts(capabilities));
        forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
            const Finding* idle = idleReasonOf(findings, path);
            // Units that are off have nothing to show; a file would have to be there.
            const bool off = path.starts_with("passes[0].units[") && !path.starts_with("passes[0].units[0]");
            if (!idle || off || row.kind == Kind::Text || row.key == "compressionQuality")
                return;
            if (!tried.insert(std::string(row.key) + ": " + idle->sentence.english()).second)
                return; // a scene before this one has shown it
            Scene changed = scene;
            const Value other =
                row.key == "texture" // one that there is
                    ? Value(static_cast<int>(scene.textures.size()) - 1 - std::get<int>(value))
                    : row.key == "border" ? Value(1 - std::get<int>(value)) // OpenGL refuses others
                                          : otherThan(row, value);
            const Result<void> set = setParam(changed, path, formatValue(row, other));
            ASSERT_TRUE(set) << path;
            EXPECT_EQ(picture(changed, 96).pixels, before.pixels)
                << "variant " << number << ", " << path << ": " << idle->sentence;
        });
        ++number;
    }
    EXPECT_GT(tried.size(), 40U);
}

/// Every entry of tables 3.21 and 3.22, and combiners: what the diagnosis calls dead changes no pixel, and
/// what it doesn't does. Undefined entries may do either.
class PrimaryColorOnTheDriver : public RenderTest {};

TEST_F(PrimaryColorOnTheDriver, HasAnEffectWhereTheDiagnosisSaysSo) {
    images.put("image", plainImage(1, 1, {153, 51, 204, 102}));
    struct Mode {
        const char* name;
        void (*edit)(Unit& unit);
    };
    const std::array modes{
        Mode{"REPLACE", [](Unit& u) { u.envMode = EnvMode::Replace; }},
        Mode{"MODULATE", [](Unit& u) { u.envMode = EnvMode::Modulate; }},
        Mode{"DECAL", [](Unit& u) { u.envMode = EnvMode::Decal; }},
        Mode{"BLEND", [](Unit& u) { u.envMode = EnvMode::Blend; }},
        Mode{"ADD", [](Unit& u) { u.envMode = EnvMode::Add; }},
        Mode{"COMBINE, the texture alone",
             [](Unit& u) {
                 u.envMode = EnvMode::Combine;
                 u.combine.rgb = CombineRgb::Replace;
                 u.combine.alpha = CombineAlpha::Replace;
             }},
        Mode{"COMBINE, alpha of what was before",
             [](Unit& u) {
                 u.envMode = EnvMode::Combine;
                 u.combine.rgb = CombineRgb::Replace;
                 u.combine.alpha = CombineAlpha::Replace;
                 u.combine.source0Alpha = CombineSource::Previous;
             }},
        Mode{"COMBINE, DOT3_RGBA, which overrules alpha",
             [](Unit& u) {
                 u.envMode = EnvMode::Combine;
                 u.combine.rgb = CombineRgb::Dot3Rgba;
                 u.combine.source1Rgb = CombineSource::Constant;
                 u.combine.alpha = CombineAlpha::Modulate;
             }},
        Mode{"COMBINE, the alpha of the primary colour as a colour",
             [](Unit& u) {
                 u.envMode = EnvMode::Combine;
                 u.combine.rgb = CombineRgb::Replace;
                 u.combine.source0Rgb = CombineSource::PrimaryColor;
                 u.combine.operand0Rgb = OperandRgb::SrcAlpha;
                 u.combine.alpha = CombineAlpha::Replace;
             }},
    };
    int dead = 0;
    for (const Mode& mode : modes) {
        for (const EnumRow& format : EnumTable<BaseFormat>::rows) {
            SCOPED_TRACE(mode.name + (" of " + std::string(format.name)));
            Scene scene = texturedScene();
            mode.edit(scene.passes[0].units[0]);
            scene.passes[0].units[0].envColor = {0.4F, 0.8F, 0.2F, 0.6F};
            scene.textures[0].internalFormat = static_cast<InternalFormat>(format.value);
            scene.material.color = untextured;
            const auto findings = diagnose(scene, images);
            const bool idle = idleReasonOf(findings, "material.color") != nullptr;
            const bool isUndefined =
                std::ranges::find(findings, "undefined-decal", &Finding::rule) != findings.end();
            const Image before = picture(scene);
            scene.material.color = {0.9F, 0.7F, 0.1F, 0.3F};
            const bool changes = picture(scene).pixels != before.pixels;
            if (isUndefined)
                EXPECT_FALSE(idle);
            else
                EXPECT_EQ(changes, !idle);
            dead += idle ? 1 : 0;
        }
    }
    EXPECT_EQ(dead, 3 + 6 + 6) << "REPLACE of LUMINANCE_ALPHA, INTENSITY and RGBA; two of the combiners";
}

} // namespace
} // namespace texplorer::diagnosis_test
