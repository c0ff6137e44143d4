// The renderer of browsers, which samples textures in its shaders, drawn here by OpenGL: it agrees with the
// reference on scenes of all of conform's features, by the rules for drivers. lessons_test.cpp has the
// lessons.

#include "app/gles/scene_painter.h"
#include "tests/support/flat_scene.h"
#include "tests/support/gl_device.h"
#include "tests/support/render_fixture.h"
#include "texplorer/conform/made_files.h"
#include "texplorer/conform/report.h"
#include "texplorer/conform/sweep.h"

#include <GL/glew.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <string>

namespace texplorer::gles_test {
namespace {

using namespace test;

/// Draws the scenes of a sweep.
class Painter : public conform::Renderer {
public:
    explicit Painter(gles::Device& device)
        : painter_(device) {}

    Result<Frame> draw(const Scene& scene) override {
        const Result<view::Frame> drawn =
            painter_.draw(scene, conform::madeImages(), 0, {conform::extent, conform::extent});
        if (!drawn)
            return fail(drawn.error());
        Result<Image> image = painter_.read();
        if (!image)
            return fail(image.error());
        return Frame{*std::move(image), drawn->problems};
    }

private:
    gles::ScenePainter painter_;
};

class ScenePainter : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        ASSERT_TRUE(GLEW_ARB_ES3_compatibility) << "the driver can't compile GLSL ES 3.00";
    }

    GlDevice device;
};

TEST_F(ScenePainter, AgreesWithTheReference) {
    Painter painter(device);
    conform::SweepOptions options;
    // This test runs for each renderer; the everyday run is that of fixed function.
    options.selection.scenes = testedRenderer() == RendererKind::Shader ? 1200 : 200;
    for (const conform::Feature& feature : conform::features()) {
        if (feature.name != "lines") // which browsers draw one pixel wide
            options.selection.features.push_back(&feature);
    }
    ASSERT_EQ(options.selection.features.size() + 1, conform::features().size());
    options.pairs = {conform::Pair{RendererKind::Shader, RendererKind::Reference}};
    const Result<conform::Report> report = conform::sweep(options, {nullptr, &painter});
    ASSERT_TRUE(report) << describe(report.error());
    EXPECT_TRUE(report->compared());
    for (const conform::Outcome& outcome : report->pairs[0].outcomes) {
        EXPECT_EQ(outcome.problem, "") << outcome.feature->name;
        EXPECT_NE(outcome.verdict(), conform::Verdict::Differ)
            << outcome.feature->name << ": " << outcome.all.shareUnexplained() << " of the pixels, at most "
            << outcome.all.max << ", worst scene " << outcome.worstScene;
    }
}

TEST_F(ScenePainter, FreesItsPrograms) {
    {
        gles::ScenePainter painter(device);
        ASSERT_TRUE(painter.draw(flatScene(), images, 0, {8, 8}));
        EXPECT_EQ(device.programs, 1);
    }
    EXPECT_EQ(device.programs, 0);
}

TEST_F(ScenePainter, RefusesSizesAndReadsNothingUndrawn) {
    gles::ScenePainter painter(device);
    EXPECT_FALSE(painter.read());
    EXPECT_EQ(painter.draw(flatScene(), images, 0, {0, 8}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(painter.draw(flatScene(), images, 0, {8, 1 << 20}).error().code, ErrorCode::OutOfRange);
}

TEST_F(ScenePainter, NamesLinesThatAreTooWide) {
    Scene scene = flatScene();
    scene.models[0].shape = Shape::Mesh;
    scene.models[0].mesh.primitive = Primitive::Lines;
    scene.models[0].mesh.positions = {glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0)};
    scene.models[0].lineWidth = 4;
    gles::ScenePainter painter(device);
    const Result<view::Frame> frame = painter.draw(scene, images, 0, {8, 8});
    ASSERT_TRUE(frame) << describe(frame.error());
    EXPECT_THAT(frame->problems,
                testing::ElementsAre("models[0]: a browser draws lines 1 pixel wide, not 4"));
}

TEST_F(ScenePainter, KeepsTheRevisionOfAnUnchangedPicture) {
    gles::ScenePainter painter(device);
    Scene scene = flatScene();
    const std::uint64_t first = painter.draw(scene, images, 0, {8, 8})->revision;
    EXPECT_EQ(painter.draw(scene, images, 0, {8, 8})->revision, first);
    scene.material.color.r = 0.5F;
    EXPECT_NE(painter.draw(scene, images, 0, {8, 8})->revision, first);
}

} // namespace
} // namespace texplorer::gles_test
