#include "app/ui/state/chosen_vertices.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/paused_encoding.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/emit/program.h"
#include "texplorer/scene/tex_coords.h"

namespace texplorer::ui::commands_tab_test {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::Not;

/// As the tab has it.
std::vector<emit::Line> programOf(const Scene& scene) {
    emit::TextureCodes codes;
    return emit::program(emit::Flavour::Fixed, scene, {}, {}, codes).value();
}

class CommandsTab : public Workbench {
protected:
    void SetUp() override { show(); }

    void show() {
        session->window.wantedTab = Tab::Commands;
        frames(3);
    }
    /// Turns the wheel over the list until a value is in sight; its place.
    ImVec2 find(std::string_view name) {
        const ImVec2 list = {place("commands:copy").x, place("commands:copy").y + 100};
        wheel(list, 200);
        for (int i = 0; i < 100 && !isWhole(name); ++i)
            wheel(list, -1);
        return place(name);
    }
    [[nodiscard]] bool isWhole(std::string_view name) const {
        const auto item = places.items.find(name);
        return item != places.items.end() && item->second.visible;
    }
    /// Another worker for the programs.
    void lendPrograms(emit::ProgramWorker& beside) {
        const Services atOnce = session->services;
        lend({atOnce.files, atOnce.levels, atOnce.reference, atOnce.kept, atOnce.probe, atOnce.levelMap,
              atOnce.patterns, atOnce.levelPictures, atOnce.lessons, atOnce.environments, atOnce.plainProbe,
              atOnce.sheet, beside, atOnce.writing});
    }
    std::string copied() {
        click("commands:copy");
        return ImGui::GetClipboardText();
    }
};

TEST_F(CommandsTab, ANumberIsDraggedInOneStepOfUndo) {
    scene().material.shininess = 32;
    frames(2);
    drag(find("command:material.shininess"), {40, 0}); // half a unit a pixel
    EXPECT_NEAR(scene().material.shininess, 52, 0.6F);
    EXPECT_EQ(session->document.lastChanged, "material.shininess");
    key('Z', {ctrl});
    EXPECT_EQ(scene().material.shininess, 32);
    EXPECT_FALSE(session->document.history.canUndo());
}

// A variable stands for what moves, and nothing there can be dragged; the present time changes no line.
TEST_F(CommandsTab, KeyFramesAreThoseOfTheProgram) {
    Scene moving = defaultScene();
    moving.timeline.keys = {{0, "material.shininess", "10"}, {2, "material.shininess", "90"}};
    start(moving);
    show();
    const std::string text = copied();
    EXPECT_EQ(text, textOf(programOf(scene()), false)) << "whose camera is fitted to the view";
    EXPECT_THAT(text, HasSubstr("GL_SHININESS, materialShininess);"));
    session->look.playback.time = 1;
    frames(2);
    EXPECT_EQ(copied(), text);
    find("command:view.fieldOfView");
    EXPECT_FALSE(has("command:material.shininess"));
}

// The camera's target stands in glTranslatef with the other sign.
TEST_F(CommandsTab, ANegatedNumberGoesTheOtherWay) {
    scene().view.target = {2, 0, 0};
    frames(2);
    drag(find("command:view.target[0]"), {40, 0});
    EXPECT_LT(scene().view.target.x, 1.9F);
}

TEST_F(CommandsTab, ANumberStaysInItsRangeAndIsTypedAfterADoubleClick) {
    drag(find("command:material.shininess"), {600, 0});
    EXPECT_EQ(scene().material.shininess, 128);
    doubleClickAt(find("command:material.shininess"));
    key('A', {ctrl});
    type("7.25");
    key(257); // Enter
    EXPECT_EQ(scene().material.shininess, 7.25F);
}

TEST_F(CommandsTab, ADecimalCommaIsTypedAsAPoint) {
    for (const Language language : {Language::English, Language::Russian, Language::Chinese}) {
        speak(language);
        frames(2);
        doubleClickAt(find("command:material.shininess"));
        key('A', {ctrl});
        type("2,5");
        key(ui::key::enter);
        EXPECT_EQ(scene().material.shininess, 2.5F);
        doubleClickAt(find("command:material.shininess"));
        key('A', {ctrl});
        type("30");
        key(ui::key::enter);
    }
}

// What was moved elsewhere is brought into sight, and nothing else glows.
TEST_F(CommandsTab, TheCoordinatesThatMovedGlow) {
    Scene square = defaultScene();
    square.models.resize(1);
    square.models[0].shape = Shape::Quad;
    start(std::move(square));
    session->settings.workspace.seams.split = 0.5F; // room for the list
    putListRight();
    show();
    const auto glowing = [&] {
        return std::ranges::count_if(
            places.items, [](const auto& item) { return item.first.starts_with("changed line:"); });
    };
    ASSERT_EQ(glowing(), 0);
    drag(place("models[0].texCoords0[2][0]"), {40, 0}); // in the tab Vertices
    EXPECT_EQ(glowing(), 1);
    ASSERT_TRUE(has("command:models[0].texCoords0[2][0]"));
    EXPECT_TRUE(isWhole("command:models[0].texCoords0[2][0]"));
    // Two of them, by an arrow key over the texture space.
    chooseVertices(session->look.selection, {0, 1});
    moveTo(place("texture space"));
    key(ui::key::up);
    frames(2);
    EXPECT_EQ(session->document.lastChanged, "models[0].texCoords0");
    EXPECT_EQ(glowing(), 2);
    key('Z', {ctrl});
    frames(2);
    EXPECT_EQ(glowing(), 0) << "undo takes back what glowed";
}

TEST_F(CommandsTab, ACoordinateOfAVertexIsDragged) {
    drag(find("command:models[0].texCoords0[2][0]"), {40, 0}); // 0.005 a pixel
    ASSERT_EQ(scene().models[0].texCoords[0].size(), 24U);
    EXPECT_NEAR(scene().models[0].texCoords[0][2].x, 1.2F, 0.006F);
    EXPECT_EQ(scene().models[0].texCoords[0][2].y, 1);
    key('Z', {ctrl});
    EXPECT_TRUE(scene().models[0].texCoords[0].empty());
}

TEST_F(CommandsTab, APositionAndANormalOfAMeshAreDragged) {
    Scene start = defaultScene();
    start.models.resize(1);
    Model& model = start.models[0];
    model.shape = Shape::Mesh;
    model.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    model.mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    this->start(std::move(start));
    show();
    drag(find("command:models[0].mesh.positions[1][0]"), {40, 0}); // 0.005 a pixel
    EXPECT_NEAR(scene().models[0].mesh.positions[1].x, 1.2F, 0.006F);
    EXPECT_EQ(scene().models[0].mesh.positions[1].y, -1);
    for (const float expected : {0.2F, 0.4F}) { // across it, and again: its length is then another than 1
        drag(find("command:models[0].mesh.normals[0][0]"), {40, 0});
        EXPECT_NEAR(scene().models[0].mesh.normals[0].x, expected, 0.012F);
        frames(2);
    }
    EXPECT_EQ(scene().models[0].mesh.normals[0].z, 1);
    for (int i = 0; i < 3; ++i)
        key('Z', {ctrl});
    EXPECT_EQ(scene().models[0].mesh.positions[1].x, 1);
    EXPECT_EQ(scene().models[0].mesh.normals[0], glm::vec3(0, 0, 1));
}

// One call stands for the vertices that share a normal, and no longer for those that only once had the same.
TEST_F(CommandsTab, ANormalIsDraggedForAllVerticesOfItsCall) {
    Scene start = defaultScene();
    start.models.resize(1);
    Model& model = start.models[0];
    model.shape = Shape::Mesh;
    model.mesh.primitive = Primitive::Points;
    model.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 1}};
    model.mesh.normals = {{1, 0, 0}, {0.2F, 0, 1}, {0.2F, 0, 1}, {0, 0, 1}};
    this->start(std::move(start));
    show();
    EXPECT_FALSE(has("command:models[0].mesh.normals[2][0]"));
    ImVec2 number = find("command:models[0].mesh.normals[1][0]");
    moveTo(number);
    ImGui::GetIO().MouseDown[0] = true;
    frames(1);
    for (int i = 0; i < 80; ++i) { // by 0.005, through 0, the last vertex's
        ImGui::GetIO().MousePos = {number.x -= 1, number.y};
        frames(1);
    }
    ImGui::GetIO().MouseDown[0] = false;
    frames(2);
    const std::vector<glm::vec3>& normals = scene().models[0].mesh.normals;
    EXPECT_EQ(normals[0], glm::vec3(1, 0, 0));
    EXPECT_NEAR(normals[1].x, -0.2F, 0.011F);
    EXPECT_EQ(normals[2], normals[1]);
    EXPECT_EQ(normals[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(session->document.history.undoName(), "Normals: vertices 1 to 2");
    key('Z', {ctrl});
    EXPECT_EQ(scene().models[0].mesh.normals[2], glm::vec3(0.2F, 0, 1));
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(CommandsTab, LeadsToAFile) {
    click("commands:export");
    click("menu:C with OpenGL 3.3");
    EXPECT_EQ(session->asking.dialog, Dialog::SaveProgram);
    EXPECT_EQ(session->asking.flavour, emit::Flavour::Glsl);
    EXPECT_EQ(states.dialogs.browser.typed, "scene.c");
}

// The last program stays, and what it has is dragged, while a thread makes the texels of the next.
TEST_F(CommandsTab, TexelsThatTakeLongHoldNothingUp) {
    PausedEncoding paused;
    emit::ProgramWorker beside(When::WhenReady, {}, paused.work());
    lendPrograms(beside);
    show();
    EXPECT_TRUE(has("commands:hint"));
    const std::string before = copied();
    ASSERT_THAT(before, HasSubstr("checkerboard("));
    texture().compression = Compression::Cached;
    frames(2);
    paused.waitUntilBegun();
    EXPECT_TRUE(has("commands:making"));
    EXPECT_EQ(copied(), before);
    drag(find("command:material.shininess"), {40, 0});
    EXPECT_NEAR(scene().material.shininess, 52, 0.6F);
    paused.goOn();
    beside.wait();
    frames(2);
    EXPECT_TRUE(has("commands:hint"));
    EXPECT_THAT(copied(),
                testing::AllOf(HasSubstr("glCompressedTexImage2D"), Not(HasSubstr("checkerboard("))));
    EXPECT_THAT(copied(), HasSubstr("GL_SHININESS, 52"));
    EXPECT_EQ(paused.shares.size(), 1U);
}

TEST_F(CommandsTab, WhatIsTakenBackIsGivenUp) {
    PausedEncoding paused(0.5F);
    emit::ProgramWorker beside(When::WhenReady, {}, paused.work());
    lendPrograms(beside);
    show();
    const Compression before = std::exchange(texture().compression, Compression::Cached);
    frames(2);
    paused.waitUntilBegun();
    EXPECT_TRUE(has("commands:making"));
    texture().compression = before;
    frames(2);
    EXPECT_TRUE(has("commands:hint"));
    EXPECT_FALSE(beside.isMaking());
    paused.goOn();
}

TEST_F(CommandsTab, OpensAtTheCallsAlsoWhereTheProgramComesLate) {
    PausedEncoding paused;
    emit::ProgramWorker beside(When::WhenReady, {}, paused.work());
    states.details.commands = {};
    lendPrograms(beside);
    texture().compression = Compression::Cached;
    show();
    paused.waitUntilBegun();
    EXPECT_FALSE(has("command:textures[0].minFilter"));
    paused.goOn();
    beside.wait();
    frames(3);
    EXPECT_TRUE(isWhole("command:textures[0].minFilter"));
}

TEST_F(CommandsTab, AChoiceHasAList) {
    clickAt(find("command:textures[0].minFilter"));
    click("command:textures[0].minFilter=GL_NEAREST");
    EXPECT_EQ(texture().minFilter, MinFilter::Nearest);
    EXPECT_EQ(session->document.lastChanged, "textures[0].minFilter");
    key('Z', {ctrl});
    EXPECT_EQ(texture().minFilter, MinFilter::LinearMipmapLinear);
}

// The call that switches off sets what OpenGL starts with; it stays while it is what changed last.
TEST_F(CommandsTab, ASwitchIsClickedAndStays) {
    clickAt(find("command:passes[0].lighting"));
    EXPECT_FALSE(scene().passes[0].lighting);
    frames(2);
    EXPECT_TRUE(has("command:passes[0].lighting"));
    EXPECT_THAT(copied(), Not(HasSubstr("GL_LIGHTING")));
    click("command:passes[0].lighting");
    EXPECT_TRUE(scene().passes[0].lighting);
}

TEST_F(CommandsTab, AColorOpensThePicker) {
    clickAt(find("command:material.specular#color"));
    ASSERT_TRUE(has("command:material.specular#picker"));
    const WidgetPlaces::Item picker = places.items.find("command:material.specular#picker")->second;
    drag({picker.left + 20, picker.top + 20}, {10, 10});
    EXPECT_NE(scene().material.specular, glm::vec4(0.5F, 0.5F, 0.5F, 1));
    key(256); // Escape
    key('Z', {ctrl});
    EXPECT_EQ(scene().material.specular, glm::vec4(0.5F, 0.5F, 0.5F, 1));
}

TEST_F(CommandsTab, SaysThatItWasCopiedUntilTheNextEdit) {
    const std::string text = copied();
    EXPECT_EQ(session->look.notice.text,
              "Copied: " + std::to_string(std::ranges::count(text, '\n')) + " lines");
    take(*session, Step{.name = "Wrap s", .edits = {edit::Set{"textures[0].wrapS", "GL_CLAMP"}}});
    EXPECT_EQ(session->look.notice.text, "");
}

TEST_F(CommandsTab, AllCallsAreListedOnDemand) {
    const char* same = "GL_TEXTURE_WRAP_S, GL_REPEAT";
    EXPECT_THAT(copied(), Not(HasSubstr(same)));
    EXPECT_EQ(copied(), textOf(programOf(scene()), false));
    click("all commands");
    EXPECT_THAT(copied(), HasSubstr(same));
    EXPECT_EQ(copied(), textOf(programOf(scene()), true));
    clickAt(find("command:textures[0].wrapS"));
    click("command:textures[0].wrapS=GL_CLAMP");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
}

TEST_F(CommandsTab, TheNameOfACallLeadsToItsControl) {
    clickAt(find("call:textures[0].minFilter"));
    EXPECT_EQ(session->look.shownParam, "textures[0].minFilter");
    frames(3);
    EXPECT_TRUE(isWhole("textures[0].minFilter") || has("textures[0].minFilter#label"));
}

TEST_F(CommandsTab, WhatIsHoveredIsLitInTheOtherPanel) {
    moveTo(find("command:textures[0].minFilter"));
    frames(2);
    EXPECT_EQ(session->window.hoveredParam, "textures[0].minFilter");
    moveTo({1, 1});
    frames(2);
    EXPECT_EQ(session->window.hoveredParam, "");
}

// What is edited elsewhere comes into sight, once: one can scroll away from it.
TEST_F(CommandsTab, TheLineThatChangedIsShown) {
    scene().models[1].topRadius = 0.5F;
    scene().models[1].shape = Shape::Cylinder;
    recordEdit(*session, "Top radius", "models[1].topRadius");
    frames(3);
    EXPECT_TRUE(isWhole("command:models[1].topRadius"));
    wheel({place("commands:copy").x, place("commands:copy").y + 100}, 200);
    frames(2);
    EXPECT_FALSE(isWhole("command:models[1].topRadius"));
}

// The call is gone, its vertex is not.
TEST_F(CommandsTab, TheVertexWhoseCallWasLeftOutIsShown) {
    EXPECT_FALSE(isWhole("command:models[0].texCoords0[19][0]"));
    scene().models[0].noTexCoord[0] = {20, 21};
    recordEdit(*session, "Leave out", "models[0].noTexCoord0");
    frames(3);
    EXPECT_FALSE(has("command:models[0].texCoords0[20][0]"));
    EXPECT_TRUE(isWhole("command:models[0].texCoords0[19][0]"));
    scene().models[0].noTexCoord[0] = {20};
    recordEdit(*session, "Send", "models[0].noTexCoord0");
    frames(3);
    EXPECT_TRUE(isWhole("command:models[0].texCoords0[21][0]"));
    EXPECT_EQ(states.details.commands.changed, ChangedPaths{"models[0].texCoords0[21]"});
    scene().models[0].noTexCoord[0] = {0, 1, 20}; // none is sent before
    recordEdit(*session, "Leave out", "models[0].noTexCoord0");
    frames(3);
    EXPECT_TRUE(isWhole("command:models[0].texCoords0[2][0]"));
}

// An edit in the parameters is seen here at once.
TEST_F(CommandsTab, FollowsTheParameters) {
    texture().wrapS = Wrap::Clamp;
    recordEdit(*session, "Wrap s", "textures[0].wrapS");
    frames(2);
    EXPECT_TRUE(has("command:textures[0].wrapS"));
    EXPECT_THAT(copied(), HasSubstr("GL_TEXTURE_WRAP_S, GL_CLAMP"));
    key('Z', {ctrl});
    frames(2);
    EXPECT_FALSE(has("command:textures[0].wrapS"));
    EXPECT_THAT(copied(), Not(HasSubstr("GL_TEXTURE_WRAP_S")));
}

// A window as small as it can be, and one without a model: nothing is drawn where it can't be.
TEST_F(CommandsTab, IsSoundWhateverThereIs) {
    Scene empty;
    empty.passes.clear();
    empty.passes.resize(1);
    for (const Scene& scene : {empty, defaultScene()}) {
        start(scene, 1024, 700);
        show();
        expectSoundFrame();
        EXPECT_FALSE(copied().empty());
    }
}

} // namespace
} // namespace texplorer::ui::commands_tab_test
