// Every step of every lesson, and every picture that is to be reached, drawn by OpenGL's renderers and by the
// reference: they agree on it as conform asks of a scene of its sweeps. What is left out, conform's rows of
// skips leave out, each with its reason.

#include "app/gles/scene_painter.h"
#include "app/view/driver_facts.h"
#include "tests/support/gl_device.h"
#include "tests/support/render_fixture.h"
#include "texplorer/conform/judge.h"
#include "texplorer/conform/skip.h"
#include "texplorer/lesson/lesson_scene.h"

#include <GL/glew.h>
#include <fmt/core.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>

namespace texplorer::lessons_test {
namespace {

using namespace test;

constexpr view::Size extent{160, 120};

bool isAnisotropic(const Scene& scene) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return pass.enabled && std::ranges::any_of(pass.units, [&](const Unit& unit) {
                   const auto texture = static_cast<std::size_t>(unit.texture);
                   return unit.enabled && texture < scene.textures.size() &&
                          scene.textures[texture].maxAnisotropy > 1;
               });
    });
}

/// Passes that mix with what the one before has left: that is rounded to 8 bits each time.
int blendedPasses(const Scene& scene) {
    return static_cast<int>(
        std::ranges::count_if(scene.passes, [](const Pass& pass) { return pass.enabled && pass.blend; }));
}

bool hasLines(const Scene& scene) {
    return std::ranges::any_of(scene.models, [](const Model& model) {
        return model.visible && model.shape == Shape::Mesh &&
               (model.mesh.primitive == Primitive::Lines || model.mesh.primitive == Primitive::LineStrip ||
                model.mesh.primitive == Primitive::LineLoop);
    });
}

/// Browsers draw them one pixel wide.
bool hasWideLines(const Scene& scene) {
    return hasLines(scene) && std::ranges::any_of(scene.models, [](const Model& model) {
               return model.visible && model.lineWidth > 1;
           });
}

/// Anisotropy may be filtered in any way, lines have ends that are snapped; the others have lambda alone that
/// a driver may round, and their passes.
conform::Rule ruleOf(const Scene& scene) {
    if (isAnisotropic(scene))
        return conform::rules::ellipse;
    conform::Rule rule = hasLines(scene) ? conform::rules::lines : conform::rules::levelBlend;
    if (blendedPasses(scene) > 0)
        rule.bound = std::max(rule.bound, conform::rules::passes.bound);
    return rule;
}

/// These renderers keep no compressed levels for the next time, and say so.
auto onlyNotKept() {
    return testing::Each(testing::HasSubstr("the compressed levels can't be cached"));
}

class Lessons : public RenderTest, public testing::WithParamInterface<std::string> {
protected:
    void expectAgreement(const lesson::LessonScene& step) {
        const conform::Driver driver{reinterpret_cast<const char*>(glGetString(GL_RENDERER)), // NOLINT: bytes
                                     capabilities.version,
                                     {},
                                     view::driverFacts(capabilities)};
        if (conform::skipOf(step.scene, {testedRenderer(), RendererKind::Reference}, driver))
            return;
        const auto reference = conform::referenceRendererFor({.scene = {},
                                                              .images = step.images,
                                                              .width = extent.width,
                                                              .height = extent.height,
                                                              .anisotropy = anisotropy()});
        const Result<Frame> ours = reference->draw(step.scene);
        ASSERT_TRUE(ours) << describe(ours.error());
        EXPECT_THAT(ours->problems, onlyNotKept());
        expectAgreement(step, *renderer, *reference, ours->image);
        if (testedRenderer() != RendererKind::Shader || hasWideLines(step.scene))
            return;
        SCOPED_TRACE("as browsers draw it");
        gles::ScenePainter painter(device_);
        const auto probing = conform::referenceRendererFor(
            {.scene = {}, .images = step.images, .width = extent.width, .height = extent.height});
        expectAgreement(step, painter, *probing, probing->draw(step.scene)->image);
    }

private:
    void expectAgreement(const lesson::LessonScene& step, auto& tested, conform::Explainer& reference,
                         const Image& ours) {
        const Result<view::Frame> frame = tested.draw(step.scene, step.images, 0, extent);
        ASSERT_TRUE(frame) << describe(frame.error());
        EXPECT_THAT(frame->problems, onlyNotKept());
        const Result<Image> theirs = tested.read();
        ASSERT_TRUE(theirs) << describe(theirs.error());
        const conform::Rule rule = ruleOf(step.scene);
        const Result<conform::Judgement> judged = conform::judge(rule, step.scene, ours, *theirs, reference);
        ASSERT_TRUE(judged) << describe(judged.error());
        const auto pixels = static_cast<double>(judged->difference.pixels);
        EXPECT_LE(static_cast<double>(judged->unexplained) / pixels, 1 - rule.explainedScene)
            << "by " << rule.name << ", the worst by " << judged->difference.max;
    }

    GlDevice device_;
};

TEST_P(Lessons, AreDrawnAlikeByEveryRenderer) {
    const lesson::LessonFolder folder = lesson::LessonFolder::builtIn(GetParam()).value();
    const lesson::Lesson lesson = readLesson(folder).value();
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        SCOPED_TRACE(fmt::format("step {}: {}", i + 1, lesson.steps[i].title));
        const Result<lesson::LessonScene> start = startOf(folder, lesson, i);
        ASSERT_TRUE(start) << describe(start.error());
        expectAgreement(*start);
        if (const auto* match = std::get_if<lesson::Match>(&lesson.steps[i].task)) {
            SCOPED_TRACE("the picture to reach");
            expectAgreement(withEdits(*start, match->edits).value());
        }
    }
}

std::string nameOf(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Lessons, testing::ValuesIn(lesson::builtInLessons()), nameOf);

} // namespace
} // namespace texplorer::lessons_test
