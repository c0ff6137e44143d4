// What is kept and what is reset when another scene is opened.

#include "app/ui/model/asking.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/scene_saving.h"
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

TEST_F(OpeningAScene, StartsTheClockAnew) {
    session->window.playback = {.playing = false, .time = 2.5, .speed = 0.25F};
    open(R"({"version": 1, "models": [{"shape": "cube", "spin": [0, 90, 0]}]})");
    EXPECT_TRUE(session->window.playback.playing);
    EXPECT_EQ(session->window.playback.time, 0);
    EXPECT_EQ(session->window.playback.speed, 1);
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

TEST_F(OpeningAScene, KeepsWhatIsTheWindowsOwn) {
    WindowState& window = session->window;
    showComparison(window.view, {RendererKind::Fixed, RendererKind::Reference});
    window.settings.workspace.seams = {300, 400, 0.4F, 0.3F};
    window.recording.width = 99;
    open(R"({"version": 1})");
    EXPECT_EQ(window.view.arrangement, Arrangement::Split);
    EXPECT_EQ(window.view.compared[1], RendererKind::Reference);
    EXPECT_EQ(window.settings.workspace.seams, (Seams{300, 400, 0.4F, 0.3F}));
    EXPECT_EQ(window.recording.width, 99);
}

TEST_F(OpeningAScene, ANewOneIsDrawnAsAtFirst) {
    open(R"({"version": 1})");
    showOne(session->window.view, RendererKind::Reference);
    session->window.view.shown = reference::Shown::Lambda;
    click("menu:File");
    click("menu:New");
    EXPECT_EQ(static_cast<const ShownPictures&>(session->window.view), ShownPictures{});
}

TEST_F(OpeningAScene, ANewOneIsDrawnByWhatThereIs) {
    ViewSettings& view = session->window.view;
    view::OfferedRenderers offered;
    offered.withhold(RendererKind::Fixed, "there is no OpenGL");
    static_cast<void>(offerRenderers(view, offered));
    showOne(view, RendererKind::Reference);
    showAsAtFirst(view);
    EXPECT_EQ(view.renderer, RendererKind::Shader) << "the first that is there";
    EXPECT_EQ(view.compared, (std::array{RendererKind::Shader, RendererKind::Reference}));
}

TEST_F(OpeningAScene, AFileEndsTheLesson) {
    ASSERT_TRUE(openLessonNamed(*session, "wrap", 2));
    open(R"({"version": 1})");
    EXPECT_FALSE(session->window.lesson);
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
    WindowState& window = session->window;
    showTab(window.settings.workspace, Tab::Figures);
    window.playback = {.playing = false, .time = 2.5, .speed = 0.25F, .loops = false};
    window.plane = {1, 2, 3};
    window.view.zoom = {4, {0.3F, 0.6F}};
    window.view.stepsThroughPasses = true;
    window.selection.unit = 2;
    window.explaining.pixel = {5, 6};
    window.explaining.texel = reference::TexelQuestion{};
    window.fileView.chosen = "/damaged.dds";
    window.recording.begin = 1;
    window.recording.seconds = 2;
    states.details.levels.face = 3;
    states.details.figures.environments.texel = glm::vec4(1);
    frames(1);
    open();
    EXPECT_TRUE(window.playback.playing);
    EXPECT_EQ(window.playback.time, 0);
    EXPECT_EQ(window.playback.speed, 1);
    EXPECT_TRUE(window.playback.loops);
    EXPECT_EQ(window.plane.extent, Plane{}.extent);
    EXPECT_EQ(window.view.zoom, PictureZoom{});
    EXPECT_FALSE(window.view.stepsThroughPasses);
    EXPECT_EQ(window.selection.unit, 0);
    EXPECT_NE(window.explaining.pixel, (reference::PixelPlace{5, 6}));
    EXPECT_FALSE(window.explaining.texel);
    EXPECT_TRUE(window.fileView.chosen.empty());
    EXPECT_EQ(window.recording.begin, 0);
    EXPECT_EQ(window.recording.seconds, std::nullopt);
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
    showComparison(session->window.view, {RendererKind::Fixed, RendererKind::Shader});
    const ShownPictures own = session->window.view;
    ASSERT_TRUE(openLessonNamed(*session, "filters", filtersWithReference));
    EXPECT_EQ(session->window.view.renderer, RendererKind::Reference);
    EXPECT_EQ(session->window.view.shown, reference::Shown::Lambda);
    open();
    const ShownPictures& shown = session->window.view;
    EXPECT_EQ(shown, GetParam().isNew ? ShownPictures{} : own);

    ASSERT_TRUE(openLessonNamed(*session, "filters", filtersWithReference));
    showOne(session->window.view, RendererKind::Shader); // the user's own choice is kept
    open();
    EXPECT_EQ(shown.renderer, GetParam().isNew ? RendererKind::Fixed : RendererKind::Shader);
}

/// The lesson would mention a scene that is no longer there.
TEST_P(AnotherDocument, EndsTheLesson) {
    ASSERT_TRUE(openLessonNamed(*session, "filters", filtersWithReference));
    const LessonRun* before = session->window.lesson.get();
    open();
    EXPECT_NE(session->window.lesson.get(), before);
    EXPECT_EQ(session->window.lesson != nullptr, session->document.isLessons);
}

INSTANTIATE_TEST_SUITE_P(
    All, AnotherDocument,
    testing::Values(
        Opening{"New", newScene, true},
        Opening{"Example", [](Session& session) { EXPECT_TRUE(openExample(session, "cube.json")); }},
        Opening{"Lesson", [](Session& session) { EXPECT_TRUE(openLessonNamed(session, "wrap", 0)); }}),
    [](const auto& test) { return std::string(test.param.name); });

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

    const Session another(session->services, session->document); // as in texshot
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
    session->window.selection.pass = 2;
    take(*session, Undo{});
    EXPECT_EQ(session->window.selection.pass, 0);
    take(*session, Redo{});
    session->window.selection.pass = 2;
    take(*session, Redo{});
    ASSERT_EQ(scene().passes.size(), 1U);
    EXPECT_EQ(session->window.selection.pass, 0);
}

TEST_F(OpeningAScene, SelectsTheFirstModelAndNoVertex) {
    session->window.selection.model = 1;
    session->window.selection.vertex = 2;
    open(R"({"version": 1, "models": [{"shape": "cube"}, {"shape": "quad"}]})");
    EXPECT_EQ(session->window.selection.model, 0);
    EXPECT_EQ(session->window.selection.vertex, std::nullopt);
}

} // namespace
} // namespace texplorer::ui::session_test
