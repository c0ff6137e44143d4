#include "texplorer/conform/feature.h"
#include "texplorer/conform/sweep.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/suite/rule_choice.h"

#include <gmock/gmock.h>

namespace texplorer::suite::rule_choice_test {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;

Scene sceneWith(std::initializer_list<std::pair<std::string_view, std::string_view>> edits) {
    Scene scene = defaultScene();
    for (const auto& [path, value] : edits) {
        const Result<void> made = setParam(scene, path, value);
        EXPECT_TRUE(made) << describe(made.error());
    }
    return scene;
}

TEST(RuleChoice, FollowsWhatASceneUses) {
    EXPECT_EQ(ruleFor(sceneWith({{"passes[0].units[0].enabled", "false"}})).name, "outline");
    EXPECT_EQ(
        ruleFor(sceneWith({{"textures[0].minFilter", "GL_LINEAR"}, {"textures[0].magFilter", "GL_LINEAR"}}))
            .name,
        "texel-edge");
    EXPECT_EQ(
        ruleFor(sceneWith({{"textures[0].minFilter", "GL_NEAREST"}, {"textures[0].magFilter", "GL_LINEAR"}}))
            .name,
        "level-choice");
    EXPECT_EQ(ruleFor(sceneWith({{"textures[0].minFilter", "GL_LINEAR_MIPMAP_NEAREST"}})).name,
              "level-choice");
    EXPECT_EQ(ruleFor(sceneWith({{"textures[0].minFilter", "GL_LINEAR_MIPMAP_LINEAR"}})).name, "level-blend");
    EXPECT_EQ(ruleFor(sceneWith({{"textures[0].minFilter", "GL_LINEAR_MIPMAP_LINEAR"},
                                 {"textures[0].mipmaps", "colored"}}))
                  .name,
              "foreign-levels");
    EXPECT_EQ(ruleFor(sceneWith({{"textures[0].maxAnisotropy", "4"}})).name, "ellipse");
}

/// A case has the same tolerance as its feature in the comparison.
TEST(RuleChoice, GrantsWhatTheComparisonGrants) {
    for (const conform::Feature& feature : conform::features()) {
        const Scene scene = conform::sceneOf(feature, 1, 0);
        const conform::Rule& rule = ruleFor(scene);
        const conform::Rule& granted = feature.reference;
        // Three passes of flat quads are rounded three times, and lines with levels use the rule for levels.
        const bool isOther = granted.name == "passes" || granted.name == "lines";
        EXPECT_GE(rule.bound, isOther ? 2 : granted.bound) << feature.name << " has " << rule.name;
        EXPECT_LE(rule.explainedScene, isOther ? 0.99 : granted.explainedScene)
            << feature.name << " has " << rule.name;
    }
}

// As in core/conform/rule.h: one word for each rule, even if rules share values.
TEST(RuleChoice, SaysWhatEachAllowsACase) {
    const std::string limits = ruleLimits();
    EXPECT_THAT(limits, HasSubstr("1 % unexplained (texel-edge, level-choice, level-blend, foreign-levels)"));
    EXPECT_THAT(limits, HasSubstr("20 % over 16, 5 % over 128 (ellipse)"));
    for (const std::string_view name : ruleNames()) {
        if (findRule(name)) {
            EXPECT_THAT(limits, ContainsRegex("[(,] ?" + std::string(name) + "[,)]"));
        }
    }
}

TEST(RuleChoice, EveryRuleOfTheComparisonHasAName) {
    for (const conform::Feature& feature : conform::features()) {
        for (const conform::Rule* rule : {&feature.reference, &feature.shader}) {
            EXPECT_THAT(ruleNames(), Contains(rule->name));
            EXPECT_EQ(findRule(rule->name), rule);
        }
    }
    EXPECT_EQ(findRule("auto"), nullptr);
    EXPECT_EQ(findRule("none"), nullptr);
}

} // namespace
} // namespace texplorer::suite::rule_choice_test
