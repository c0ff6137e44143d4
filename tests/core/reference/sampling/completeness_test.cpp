#include "tests/core/reference/textures.h"
#include "texplorer/reference/sampling/completeness.h"

#include <gmock/gmock.h>

namespace texplorer::reference::completeness_test {
namespace {

using namespace test;
using Rule = CompletenessRule;

struct Case {
    const char* name;
    void (*change)(SampledTexture& texture);
    Rule rule;
    int level;
    const char* reason;
};

class CompletenessOf : public testing::TestWithParam<Case> {};

// 8 x 8 texels: levels 0 to 3.
TEST_P(CompletenessOf, NamesTheLevelAndTheRule) {
    SampledTexture texture = leveledTexture(8);
    texture.minFilter = MinFilter::LinearMipmapLinear;
    GetParam().change(texture);
    const Completeness found = checkCompleteness(texture);
    EXPECT_EQ(found.rule, GetParam().rule);
    EXPECT_EQ(found.level, GetParam().level);
    EXPECT_THAT(found.reason, testing::HasSubstr(GetParam().reason));
    EXPECT_EQ(found.complete(), found.reason.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, CompletenessOf,
    testing::Values(Case{"Complete", [](SampledTexture&) {}, Rule::Complete, 0, ""},
                    Case{"Missing", [](SampledTexture& it) { it.levels[2] = {}; }, Rule::LevelMissing, 2,
                         "GL_LINEAR_MIPMAP_LINEAR needs the levels 0 to 3, and level 2 is missing"},
                    Case{"TheLastMissing", [](SampledTexture& it) { it.levels.pop_back(); },
                         Rule::LevelMissing, 3, "level 3"},
                    Case{"NotNeededAboveMaxLevel",
                         [](SampledTexture& it) {
                             it.levels.pop_back();
                             it.maxLevel = 2;
                         },
                         Rule::Complete, 0, ""},
                    Case{"NotNeededWithoutMipmaps",
                         [](SampledTexture& it) {
                             it.levels.resize(1);
                             it.minFilter = MinFilter::Linear;
                         },
                         Rule::Complete, 0, ""},
                    Case{"NotNeededBelowTheBase",
                         [](SampledTexture& it) {
                             it.levels[0] = {};
                             it.baseLevel = 1;
                         },
                         Rule::Complete, 0, ""},
                    Case{"NoBase", [](SampledTexture& it) { it.baseLevel = 7; }, Rule::BaseLevelMissing, 7,
                         "base level is 7"},
                    Case{"NegativeBase", [](SampledTexture& it) { it.baseLevel = -1; },
                         Rule::BaseLevelMissing, -1, ""},
                    Case{"BaseAboveMax",
                         [](SampledTexture& it) {
                             it.baseLevel = 2;
                             it.maxLevel = 1;
                         },
                         Rule::BaseAboveMaxLevel, 2, "base level 2 exceeds its maximal level 1"},
                    // Section 3.8.10 asks for a chain where the filter does; without, the base level is the
                    // texture, whatever the maximal level.
                    Case{"BaseAboveMaxWithoutMipmaps",
                         [](SampledTexture& it) {
                             it.baseLevel = 2;
                             it.maxLevel = 1;
                             it.minFilter = MinFilter::Nearest;
                         },
                         Rule::Complete, 0, ""},
                    Case{"WrongSize",
                         [](SampledTexture& it) {
                             it.levels[1] = makeLevel({4, 3, 1}, [](int, int, int) { return glm::vec4(0); });
                         },
                         Rule::LevelSize, 1, "4 × 4 texels and has 4 × 3"},
                    Case{"WrongBorder",
                         [](SampledTexture& it) {
                             it.levels[1] = makeLevel(
                                 {4, 4, 1}, [](int, int, int) { return glm::vec4(0); }, 1);
                         },
                         Rule::LevelBorder, 1, "border of 1"}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::completeness_test
