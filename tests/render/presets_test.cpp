// What a preset makes of the start scene, drawn by OpenGL's renderers and by the reference: they agree on it
// as conform asks of a scene of its sweeps.

#include "tests/support/render_fixture.h"
#include "texplorer/conform/feature.h"
#include "texplorer/conform/judge.h"
#include "texplorer/preset/preset.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

namespace texplorer::presets_test {
namespace {

using namespace test;

/// Anisotropy may be filtered in any way; the others have lambda alone that a driver may round.
const conform::Rule& ruleOf(const Scene& scene) {
    return scene.textures[0].maxAnisotropy > 1 ? conform::rules::ellipse : conform::rules::levelBlend;
}

class Presets : public RenderTest, public testing::WithParamInterface<Preset> {};

TEST_P(Presets, AreDrawnAlikeByEveryRenderer) {
    Scene scene = defaultScene();
    const Result<void> done = applyPreset(GetParam(), scene);
    ASSERT_TRUE(done) << describe(done.error());
    const Image theirs = picture(scene, conform::extent);
    const bool isRefused = GetParam().name == "wrong-format";
    EXPECT_EQ(problems.size(), isRefused ? 1U : 0U);
    const std::unique_ptr<conform::Explainer> reference =
        conform::referenceRendererWith(images, {capabilities.renderer, capabilities.version});
    const Result<Frame> ours = reference->draw(scene);
    ASSERT_TRUE(ours) << describe(ours.error());
    EXPECT_EQ(ours->problems, problems);
    const conform::Rule& rule = ruleOf(scene);
    const Result<conform::Judgement> judged = conform::judge(rule, scene, ours->image, theirs, *reference);
    ASSERT_TRUE(judged) << describe(judged.error());
    const auto pixels = static_cast<double>(judged->difference.pixels);
    EXPECT_LE(static_cast<double>(judged->unexplained) / pixels, 1 - rule.explainedScene)
        << "the worst by " << judged->difference.max;
}

std::string nameOf(const testing::TestParamInfo<Preset>& info) {
    std::string name(info.param.name);
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Presets, testing::ValuesIn(presets().begin(), presets().end()), nameOf);

} // namespace
} // namespace texplorer::presets_test
