// What is kept and what is reset when another scene is opened.

#include "app/ui/files/asking.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/notice.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
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

TEST_F(OpeningAScene, KeepsTheColumnsOfTheVertexList) {
    showTab(session->settings.workspace, Tab::Vertices);
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
    EXPECT_TRUE(isShown(session->settings.workspace, Tab::Glsl));
}

TEST_F(OpeningAScene, KeepsWhatIsTheWindowsOwn) {
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Reference});
    session->settings.workspace.seams = {300, 400, 0.4F, 0.3F};
    session->recording.width = 99;
    open(R"({"version": 1})");
    EXPECT_EQ(session->view.arrangement, Arrangement::Split);
    EXPECT_EQ(session->view.compared[1], RendererKind::Reference);
    EXPECT_EQ(session->settings.workspace.seams, (Seams{300, 400, 0.4F, 0.3F}));
    EXPECT_EQ(session->recording.width, 99);
}

TEST_F(OpeningAScene, ANewOneIsDrawnAsAtFirst) {
    open(R"({"version": 1})");
    showOne(session->view, RendererKind::Reference);
    session->view.shown = reference::Shown::Lambda;
    click("menu:File");
    click("menu:New");
    EXPECT_EQ(static_cast<const ShownPictures&>(session->view), ShownPictures{});
}

TEST_F(OpeningAScene, ANewOneIsDrawnByWhatThereIs) {
    ViewSettings& view = session->view;
    view::OfferedRenderers offered;
    offered.withhold(RendererKind::Fixed, "there is no OpenGL");
    static_cast<void>(offerRenderers(view, offered));
    showOne(view, RendererKind::Reference);
    showAsAtFirst(view);
    EXPECT_EQ(view.renderer, RendererKind::Shader) << "the first that is there";
    EXPECT_EQ(view.compared, (std::array{RendererKind::Shader, RendererKind::Reference}));
}

constexpr std::size_t filtersWithReference = 4; // a step that shows λ, as the reference has it

struct Opening {
    const char* name;
    void (*open)(Session& session);
    bool isNew = false; ///< then no setting of the old scene's drawing is kept
};

void PrintTo(const Opening& opening, std::ostream* out) {
    *out << opening.name;
}

class AnotherDocument : public Workbench, public testing::WithParamInterface<Opening> {
protected:
    void open() {
        GetParam().open(*session);
        frames(3);
    }
};

TEST_P(AnotherDocument, IsLookedAtAnew) {
    showTab(session->settings.workspace, Tab::Figures);
    session->look.playback = {.playing = false, .time = 2.5, .speed = 0.25F, .loops = false};
    session->look.plane = {1, 2, 3};
    session->view.zoom = {4, {0.3F, 0.6F}};
    session->view.stepsThroughPasses = true;
    session->look.selection.unit = 2;
    session->look.explaining.pixel = {5, 6};
    session->look.explaining.texel = reference::TexelQuestion{};
    session->look.fileView.chosen = "/damaged.dds";
    say(*session, "brick.bmp has changed and can't be read now.");
    session->recording.begin = 1;
    session->recording.seconds = 2;
    states.details.levels.face = 3;
    states.details.figures.environments.texel = glm::vec4(1);
    frames(1);
    open();
    EXPECT_TRUE(session->look.playback.playing);
    EXPECT_EQ(session->look.playback.time, 0);
    EXPECT_EQ(session->look.playback.speed, 1);
    EXPECT_TRUE(session->look.playback.loops);
    EXPECT_EQ(session->look.plane.extent, Plane{}.extent);
    EXPECT_EQ(session->view.zoom, PictureZoom{});
    EXPECT_FALSE(session->view.stepsThroughPasses);
    EXPECT_EQ(session->look.selection.unit, 0);
    EXPECT_NE(session->look.explaining.pixel, (reference::PixelPlace{5, 6}));
    EXPECT_FALSE(session->look.explaining.texel);
    EXPECT_TRUE(session->look.fileView.chosen.empty());
    EXPECT_EQ(session->look.notice.text, "");
    EXPECT_EQ(session->recording.begin, 0);
    EXPECT_EQ(session->recording.seconds, std::nullopt);
    EXPECT_EQ(states.details.levels.face, 0);
    EXPECT_EQ(states.details.figures.environments.texel, std::nullopt);
}

/// A key moves vertices with the mouse until a click: those of the shown scene.
TEST_P(AnotherDocument, IsNotWhereVerticesAreMovedThatWereTheOldOnes) {
    states.textureSpace.move = VertexMove{.byKey = true, .vertices = {0}, .places = {{0, 0}}};
    open();
    EXPECT_FALSE(states.textureSpace.move);
}

TEST_P(AnotherDocument, IsNotDrawnByTheRenderersOfALessonsStep) {
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Shader});
    const ShownPictures own = session->view;
    ASSERT_TRUE(openLessonNamed(*session, "filters", filtersWithReference));
    EXPECT_EQ(session->view.renderer, RendererKind::Reference);
    EXPECT_EQ(session->view.shown, reference::Shown::Lambda);
    open();
    const ShownPictures& shown = session->view;
    EXPECT_EQ(shown, GetParam().isNew ? ShownPictures{} : own);

    ASSERT_TRUE(openLessonNamed(*session, "filters", filtersWithReference));
    showOne(session->view, RendererKind::Shader); // the user's own choice is kept
    open();
    EXPECT_EQ(shown.renderer, GetParam().isNew ? RendererKind::Fixed : RendererKind::Shader);
}

/// The lesson would mention a scene that is no longer there.
TEST_P(AnotherDocument, EndsTheLesson) {
    ASSERT_TRUE(openLessonNamed(*session, "filters", filtersWithReference));
    open();
    EXPECT_TRUE(!session->lesson || session->lesson->key != "filters");
    EXPECT_EQ(session->lesson.has_value(), session->document.isLessons);
}

INSTANTIATE_TEST_SUITE_P(
    All, AnotherDocument,
    testing::Values(
        Opening{"New", newScene, true},
        Opening{"File",
                [](Session& session) {
                    const texplorer::test::TempDir folder;
                    texplorer::test::writeRaw(folder / "scene.json", R"({"version": 1})");
                    EXPECT_TRUE(openScene(session, folder / "scene.json"));
                }},
        Opening{"Example", [](Session& session) { EXPECT_TRUE(openExample(session, "cube.json")); }},
        Opening{"Lesson", [](Session& session) { EXPECT_TRUE(openLessonNamed(session, "wrap", 0)); }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(OpeningAScene, SelectsAModelThatIsSeen) {
    click("show:Sphere");
    ASSERT_TRUE(saveScene(*session, folder / "sphere.json").has_value());
    askNewScene(*session);
    frames(2);
    session->look.selection = {.model = 0, .vertex = 3, .pass = 0, .unit = 0};
    frames(1);
    ASSERT_EQ(selectedModel(*session)->shape, Shape::Cube);

    ASSERT_TRUE(openScene(*session, folder / "sphere.json").has_value());
    frames(3);
    EXPECT_EQ(selectedModel(*session)->shape, Shape::Sphere);
    EXPECT_EQ(session->look.selection.vertex, std::nullopt);

    const Session another(session->services, session->document); // as in texshot
    EXPECT_EQ(another.document.scene.models[static_cast<std::size_t>(another.look.selection.model)].shape,
              Shape::Sphere);
}

TEST_F(OpeningAScene, SelectsNoPassThatThereIsNotAtAnyTime) {
    scene().passes.resize(3);
    session->look.selection.pass = 2;
    newScene(*session); // no frame in between
    EXPECT_EQ(session->look.selection.pass, 0);
    EXPECT_EQ(&selectedPass(*session), &scene().passes[0]);
}

// A menu does it during a frame.
TEST_F(OpeningAScene, UndoAndRedoSelectNoPassThatThereIsNotAtAnyTime) {
    const auto havePasses = [&](std::size_t count) {
        scene().passes.resize(count);
        recordEdit(*session, "Passes");
        take(*session, EndStep{});
    };
    havePasses(3);
    havePasses(1);
    take(*session, Undo{});
    session->look.selection.pass = 2;
    take(*session, Undo{});
    EXPECT_EQ(session->look.selection.pass, 0);
    take(*session, Redo{});
    session->look.selection.pass = 2;
    take(*session, Redo{});
    ASSERT_EQ(scene().passes.size(), 1U);
    EXPECT_EQ(session->look.selection.pass, 0);
}

TEST_F(OpeningAScene, SelectsTheFirstModelAndNoVertex) {
    session->look.selection.model = 1;
    session->look.selection.vertex = 2;
    open(R"({"version": 1, "models": [{"shape": "cube"}, {"shape": "quad"}]})");
    EXPECT_EQ(session->look.selection.model, 0);
    EXPECT_EQ(session->look.selection.vertex, std::nullopt);
}

} // namespace
} // namespace texplorer::ui::session_test
