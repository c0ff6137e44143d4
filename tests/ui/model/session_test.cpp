// What stays and what goes when another scene is opened.

#include "app/ui/model/asking.h"
#include "app/ui/model/scene_files.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::session_test {
namespace {

using namespace test;

class OpeningAScene : public Workbench {
protected:
    void open(const std::string& text) {
        texplorer::test::writeRaw(folder / "scene.json", text);
        ASSERT_TRUE(openScene(*session, folder / "scene.json").has_value());
        frames(3);
        ASSERT_EQ(session->document.file, folder / "scene.json");
    }
    texplorer::test::TempDir folder;
};

TEST_F(OpeningAScene, ReplacesTheDocument) {
    choose("textures[0].wrapS", "GL_CLAMP");
    ASSERT_TRUE(session->document.history.canUndo());
    open(R"({"version": 1, "textures": [{"wrapT": "GL_CLAMP"}]})");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(texture().wrapT, Wrap::Clamp);
    EXPECT_EQ(session->document.saved, scene());
    EXPECT_FALSE(session->document.history.canUndo());
    EXPECT_EQ(session->document.lastChanged, "");
}

TEST_F(OpeningAScene, KeepsTheClockAndItsSpeed) {
    session->window.playback = {.playing = false, .time = 2.5, .speed = 0.25F};
    open(R"({"version": 1, "models": [{"shape": "cube", "spin": [0, 90, 0]}]})");
    EXPECT_FALSE(session->window.playback.playing);
    EXPECT_EQ(session->window.playback.time, 2.5);
    EXPECT_EQ(session->window.playback.speed, 0.25F);
}

TEST_F(OpeningAScene, KeepsTheColumnsOfTheVertexList) {
    showTab(session->window.settings.workspace, Tab::Vertices);
    frames(2);
    click("show r, q");
    ASSERT_TRUE(has("models[0].texCoords0[0][3]"));
    open(R"({"version": 1, "models": [{"shape": "cube"}]})");
    EXPECT_TRUE(session->window.showRq);
    EXPECT_TRUE(has("models[0].texCoords0[0][3]")) << "q of the first vertex";
}

TEST_F(OpeningAScene, KeepsTheStageOfTheShaders) {
    click("tab:GLSL");
    for (int i = 0; i < 3; ++i)
        (void)picture();
    states.details.glsl.stage = view::ShaderStage::Vertex;
    open(R"({"version": 1})");
    EXPECT_EQ(states.details.glsl.stage, view::ShaderStage::Vertex);
    EXPECT_TRUE(isShown(session->window.settings.workspace, Tab::Glsl));
}

TEST_F(OpeningAScene, KeepsHowOneLooksAtIt) {
    WindowState& window = session->window;
    showComparison(window.view, {RendererKind::Fixed, RendererKind::Reference});
    window.view.zoom = {4, {0.3F, 0.6F}};
    window.plane = {1, 2, 3};
    window.settings.workspace.seams = {300, 400, 0.4F, 0.3F};
    window.selection.unit = 2;
    window.explaining.pixel = {5, 6};
    open(R"({"version": 1})");
    EXPECT_EQ(window.view.arrangement, Arrangement::Split);
    EXPECT_EQ(window.view.compared[1], RendererKind::Reference);
    EXPECT_EQ(window.view.zoom, (PictureZoom{4, {0.3F, 0.6F}}));
    EXPECT_EQ(window.plane.extent, 3);
    EXPECT_EQ(window.settings.workspace.seams, (Seams{300, 400, 0.4F, 0.3F}));
    EXPECT_EQ(window.selection.unit, 2);
    EXPECT_EQ(window.explaining.pixel, (reference::PixelPlace{5, 6}));
}

TEST_F(OpeningAScene, TakesBackWhatWasSaidOfTheOldOne) {
    say(*session, "brick.bmp has changed and can't be read now.");
    open(R"({"version": 1})");
    EXPECT_EQ(session->window.notice.text, "");
}

TEST_F(OpeningAScene, SelectsAModelThatIsSeen) {
    click("show:Sphere");
    ASSERT_TRUE(saveScene(*session, folder / "sphere.json").has_value());
    askNewScene(*session);
    frames(2);
    session->window.selection = {.model = 0, .vertex = 3, .pass = 0, .unit = 0};
    frames(1);
    ASSERT_EQ(selectedModel(*session)->shape, Shape::Cube);

    ASSERT_TRUE(openScene(*session, folder / "sphere.json").has_value());
    frames(3);
    EXPECT_EQ(selectedModel(*session)->shape, Shape::Sphere);
    EXPECT_EQ(session->window.selection.vertex, std::nullopt);

    const Session another(session->services, session->document); // as texshot begins with it
    EXPECT_EQ(another.document.scene.models[static_cast<std::size_t>(another.window.selection.model)].shape,
              Shape::Sphere);
}

TEST_F(OpeningAScene, SelectsNoPassThatThereIsNotAtAnyTime) {
    scene().passes.resize(3);
    session->window.selection.pass = 2;
    newScene(*session); // no frame in between
    EXPECT_EQ(session->window.selection.pass, 0);
    EXPECT_EQ(&selectedPass(*session), &scene().passes[0]);
}

// A menu does it in the middle of a frame.
TEST_F(OpeningAScene, UndoAndRedoSelectNoPassThatThereIsNotAtAnyTime) {
    const auto havePasses = [&](std::size_t count) {
        scene().passes.resize(count);
        recordEdit(*session, "Passes");
        sealEdit(*session);
    };
    havePasses(3);
    havePasses(1);
    undo(*session);
    session->window.selection.pass = 2;
    undo(*session);
    EXPECT_EQ(session->window.selection.pass, 0);
    redo(*session);
    session->window.selection.pass = 2;
    redo(*session);
    ASSERT_EQ(scene().passes.size(), 1U);
    EXPECT_EQ(session->window.selection.pass, 0);
}

TEST_F(OpeningAScene, LeavesAModelSelectedThatIsSeenInBoth) {
    session->window.selection.model = 1;
    session->window.selection.vertex = 2;
    open(R"({"version": 1, "models": [{"shape": "cube"}, {"shape": "quad"}]})");
    EXPECT_EQ(session->window.selection.model, 1);
    EXPECT_EQ(session->window.selection.vertex, 2U);
    open(R"({"version": 1, "models": [{"shape": "cube"}]})");
    EXPECT_EQ(session->window.selection.model, 0) << "there is one model alone";
}

} // namespace
} // namespace texplorer::ui::session_test
