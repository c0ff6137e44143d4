#include "tests/core/diagnosis/mistakes.h"
#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace texplorer::diagnosis_test {
namespace {

using namespace test;
using enum Severity;

const Finding* find(const std::vector<Finding>& findings, std::string_view rule, std::string_view path) {
    for (const Finding& each : findings) {
        if (each.rule == rule && each.path == path)
            return &each;
    }
    return nullptr;
}

class Diagnosis : public testing::TestWithParam<Mistake> {};

TEST_P(Diagnosis, FindsItAndNoLongerOnceItIsMended) {
    const Mistake& row = GetParam();
    Subject stage;
    row.spoil(stage);
    const std::vector<Finding> findings = stage.findings();
    const Finding* found = find(findings, row.rule, row.path);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->severity, row.severity);
    EXPECT_THAT(found->sentence, testing::HasSubstr(row.words));
    ASSERT_TRUE(row.correct || !found->fixes.empty());
    if (row.correct) {
        row.correct(stage);
        EXPECT_EQ(find(stage.findings(), row.rule, row.path), nullptr);
    }
    for (const Fix& fix : found->fixes) {
        Subject fixed = stage;
        if (row.correct)
            row.spoil(fixed);
        const Result<void> applied = apply(fix, fixed.scene);
        ASSERT_TRUE(applied) << describe(applied.error());
        EXPECT_EQ(find(fixed.findings(), row.rule, row.path), nullptr) << fix.label;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Diagnosis, testing::ValuesIn(mistakes()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DiagnosisOfAll, EveryRuleHasAMistake) {
    std::set<std::string_view> found;
    for (const Mistake& each : mistakes())
        found.insert(each.rule);
    using namespace diagnosis;
    for (const std::span<const Rule> rules :
         {textureRules(), uploadRules(), formatRules(), unitRules(), cubeRules(), combineRules(), passRules(),
          modelRules(), vertexRules(), lightRules(), sideRules(), fogRules(), depthRules(),
          textureEffectRules()}) {
        for (const Rule& rule : rules)
            EXPECT_TRUE(found.contains(rule.name)) << rule.name;
    }
}

TEST(DiagnosisOfAll, OffersAPatternForALevelOfAnotherSize) {
    Subject stage;
    stage.showFile(8, 2);
    stage.texture().source = SourceKind::Pattern;
    stage.texture().mipmaps = MipPolicy::Given;
    stage.texture().levels.resize(6);
    stage.texture().levels[1] = {.source = SourceKind::File, .file = "image.png"};
    const std::vector<Finding> findings = stage.findings();
    const Finding* found = find(findings, "incomplete", "textures[0].levels[1].file");
    ASSERT_NE(found, nullptr);
    ASSERT_FALSE(found->fixes.empty());
    EXPECT_EQ(found->fixes[0].label, "Put a pattern on level 2");
    ASSERT_TRUE(apply(found->fixes[0], stage.scene));
    EXPECT_EQ(find(stage.findings(), "incomplete", "textures[0].levels[1].file"), nullptr);
}

TEST(DiagnosisOfAll, SaysOfSrgbWhyThePictureIsDarkBeforeItsLevels) {
    Subject stage;
    stage.texture().internalFormat = InternalFormat::Srgb8;
    stage.texture().mipmaps = MipPolicy::Generated;
    stage.texture().minFilter = MinFilter::LinearMipmapLinear;
    const std::vector<Finding> findings = stage.findings();
    const auto cause = std::ranges::find(findings, "srgb-not-encoded", &Finding::rule);
    const auto levels = std::ranges::find(findings, "srgb-levels", &Finding::rule);
    ASSERT_NE(cause, findings.end());
    ASSERT_NE(levels, findings.end());
    EXPECT_LT(cause, levels);
}

TEST(DiagnosisOfAll, TheDefaultSceneIsFreeOfErrorsAndWarnings) {
    for (const Finding& each : Subject().findings())
        EXPECT_GE(each.severity, Severity::Hint) << each.path << ": " << each.sentence;
}

TEST(DiagnosisOfAll, EveryPathIsThatOfAParameterOrOfAStruct) {
    Subject stage;
    stage.scene.passes.resize(2);
    stage.combine().rgb = CombineRgb::Dot3Rgba;
    stage.unit().matrix.resize(2);
    std::set<std::string> paths;
    forEachParam(stage.scene, [&](const std::string& path, const ParamRow&, const Value&) {
        for (std::size_t end = path.find('.'); end != std::string::npos; end = path.find('.', end + 1))
            paths.insert(path.substr(0, end));
        paths.insert(path);
    });
    const std::vector<Finding> findings = stage.findings();
    EXPECT_GT(findings.size(), 50U);
    for (const Finding& each : findings) {
        EXPECT_TRUE(paths.contains(each.path)) << each.path;
        EXPECT_FALSE(each.sentence.empty()) << each.path;
        EXPECT_FALSE(each.sentence.english().ends_with('.')) << each.sentence;
    }
    EXPECT_TRUE(std::ranges::is_sorted(findings, {}, &Finding::severity));
}

TEST(DiagnosisOfAll, AStructSpeaksForAllBelowIt) {
    const std::vector<Finding> findings = Subject().findings();
    const Finding* found = idleReasonOf(findings, "passes[0].units[0].combine.source0Rgb");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->path, "passes[0].units[0].combine");
    EXPECT_EQ(idleReasonOf(findings, "textures[0].minFilter"), nullptr);
    EXPECT_EQ(problemOf(findings, "textures[0].minFilter"), nullptr);
    EXPECT_EQ(idleReasonOf({{"r", Hint, "textures[1]", "s", {}}}, "textures[10].file"), nullptr);
}

TEST(DiagnosisOfAll, TheSwitchOfAUnitThatIsOffHasAnEffect) {
    Subject stage;
    stage.unit().enabled = false;
    const std::vector<Finding> findings = stage.findings();
    EXPECT_NE(idleReasonOf(findings, "passes[0].units[0].envMode"), nullptr);
    EXPECT_NE(idleReasonOf(findings, "passes[0].units[0].matrix[0].amount"), nullptr);
    EXPECT_EQ(idleReasonOf(findings, "passes[0].units[0].enabled"), nullptr);
}

TEST(DiagnosisOfAll, TheColorControlStillBringsTheHighlightBack) {
    Subject stage;
    stage.unit().envMode = EnvMode::Replace;
    EXPECT_EQ(idleReasonOf(stage.findings(), "light.colorControl"), nullptr);
    stage.scene.light.colorControl = ColorControl::SeparateSpecular;
    for (const char* path : {"light.position", "light.specular", "material.shininess", "passes[0].lighting"})
        EXPECT_EQ(idleReasonOf(stage.findings(), path), nullptr) << path;
}

TEST(DiagnosisOfAll, TheSwitchOfAHiddenModelHasAnEffect) {
    Subject stage;
    stage.scene.models[1].visible = false;
    EXPECT_NE(idleReasonOf(stage.findings(), "models[1].size"), nullptr);
    EXPECT_EQ(idleReasonOf(stage.findings(), "models[1].visible"), nullptr);
    EXPECT_EQ(idleReasonOf(stage.findings(), "models[0].size"), nullptr);
}

TEST(DiagnosisOfAll, ALaterPassIsMendedWithoutHidingIt) {
    Subject stage;
    stage.scene.passes.push_back({});
    const std::vector<Finding> before = stage.findings();
    const Finding* found = find(before, "no-depth-test", "passes[1].depthTest");
    ASSERT_NE(found, nullptr);
    ASSERT_TRUE(apply(found->fixes.front(), stage.scene));
    for (const Finding& each : stage.findings())
        EXPECT_GE(each.severity, Hint) << each.path << ": " << each.sentence;
}

std::vector<std::string> labelsOf(const std::vector<Fix>& fixes) {
    std::vector<std::string> labels;
    for (const Fix& each : fixes)
        labels.push_back(each.label);
    return labels;
}

TEST(DiagnosisOfIncompleteTextures, OffersEachSettingThatCompletes) {
    using testing::ElementsAre;
    const auto fixes = [](void (*spoil)(Subject&)) {
        Subject stage;
        spoil(stage);
        for (const Finding& each : stage.findings()) {
            if (each.rule == "incomplete")
                return labelsOf(each.fixes);
        }
        return std::vector<std::string>{};
    };
    EXPECT_THAT(fixes([](Subject& s) { s.texture().mipmaps = MipPolicy::None; }),
                ElementsAre("Generate mipmaps", "End at level 0", "Set GL_LINEAR"));
    EXPECT_THAT(fixes([](Subject& s) {
                    s.texture().mipmaps = MipPolicy::Missing; // level 3 isn't there
                    s.texture().minFilter = MinFilter::NearestMipmapLinear;
                }),
                ElementsAre("Generate mipmaps", "End at level 2", "Set GL_NEAREST"));
    EXPECT_THAT(fixes([](Subject& s) {
                    s.texture().baseLevel = 3;
                    s.texture().maxLevel = 2;
                }),
                ElementsAre("Begin at level 2", "End at level 6", "Set GL_LINEAR"));
    EXPECT_THAT(fixes([](Subject& s) { s.texture().baseLevel = 50; }), ElementsAre("Begin at level 0"));
    EXPECT_THAT(fixes([](Subject& s) {
                    s.texture().baseLevel = 50;
                    s.texture().mipmaps = MipPolicy::None;
                }),
                ElementsAre("Begin at level 0 and generate mipmaps", "Begin at level 0 and end at level 0",
                            "Begin at level 0 and set GL_LINEAR"));
    EXPECT_THAT(fixes([](Subject& s) {
                    s.showFile(8, 4);
                    s.unit().target = Target::CubeMap;
                }),
                testing::IsEmpty());
}

TEST(DiagnosisOfDepths, HasNothingToSayOfAShadowMap) {
    Subject stage;
    castShadows(stage);
    stage.pass().lighting = false; // the light is used anyway
    for (const Finding& each : stage.findings()) {
        EXPECT_GE(each.severity, Hint) << each.path << ": " << each.sentence;
        EXPECT_FALSE(each.path == "light" || each.path == "light.position" ||
                     each.path == "light.projector" || each.path == "passes[0].units[0].texGenR.enabled")
            << each.path << ": " << each.sentence;
    }
}

TEST(DiagnosisOfAll, AFixThatNoLongerFitsChangesNothing) {
    Scene scene = defaultScene();
    const Fix fix{"", {{"textures[0].baseLevel", "3"}, {"textures[5].baseLevel", "3"}}};
    EXPECT_FALSE(apply(fix, scene));
    EXPECT_EQ(scene, defaultScene());
}

} // namespace
} // namespace texplorer::diagnosis_test
