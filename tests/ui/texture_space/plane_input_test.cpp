// Mouse and keys over the texture space: selecting and moving.

#include "app/ui/files/scene_files.h"
#include "app/ui/state/chosen_vertices.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/texture_space/plane_bench.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/scene/mesh_edits.h"

#include <glm/glm.hpp>

namespace texplorer::ui::plane_input_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

class PlaneInput : public PlaneBench {
protected:
    PlaneInput()
        : PlaneBench(Shape::Quad) {}

    void expectPlace(const char* name, float s, float t) {
        EXPECT_NEAR(place(name).x, at(s, t).x, 0.5F) << name;
        EXPECT_NEAR(place(name).y, at(s, t).y, 0.5F) << name;
    }
    std::vector<std::size_t> chosen() { return chosenVertices(session->look.selection); }
    /// Begins a move of vertex 2 by its key, with the mouse in the middle.
    void grab() {
        clickAt(place("coord:2"));
        moveTo(at(0.5F, 0.5F));
        key('G');
    }
};

TEST_F(PlaneInput, ShiftAndAClickAddAndTakeAway) {
    clickAt(place("coord:0"));
    {
        const Held shifted(*this, shift);
        clickAt(place("coord:2"));
        EXPECT_THAT(chosen(), ElementsAre(0, 2));
        EXPECT_EQ(session->look.selection.vertex, 2U);
        clickAt(place("coord:0"));
    }
    EXPECT_THAT(chosen(), ElementsAre(2));
    clickAt(at(0.5F, 0.5F));
    EXPECT_THAT(chosen(), IsEmpty());
}

TEST_F(PlaneInput, ADragWithShiftChoosesWhatIsInItsBox) {
    const Plane before = session->look.plane;
    {
        const Held shifted(*this, shift);
        dragTo(at(0.5F, -0.1F), at(1.1F, 1.1F));
    }
    EXPECT_THAT(chosen(), ElementsAre(1, 2));
    EXPECT_EQ(session->look.plane.s, before.s) << "the plane stays";
    EXPECT_EQ(undoSteps(), 0U) << "what is chosen is no edit";
}

TEST_F(PlaneInput, InItsModeADragNeedsNoShift) {
    state().selects = true;
    clickAt(place("coord:0"));
    dragTo(at(0.5F, 0.5F), at(1.1F, 1.1F));
    EXPECT_THAT(chosen(), ElementsAre(2)) << "in the place of those before";
    const Plane before = session->look.plane;
    const Held shifted(*this, shift);
    dragTo(at(0.5F, 0.5F), at(1.1F, 1.1F));
    EXPECT_LT(session->look.plane.s, before.s) << "with Shift it moves the plane";
}

TEST_F(PlaneInput, SeveralMoveTogetherInOneStep) {
    clickAt(place("coord:1"));
    {
        const Held shifted(*this, shift);
        clickAt(place("coord:2"));
    }
    const float unit = pixelsPerUnit();
    drag(place("coord:1"), {30, -12});
    expectCoord(1, 1 + 30 / unit, 12 / unit);
    expectCoord(2, 1 + 30 / unit, 1 + 12 / unit);
    expectCoord(0, 0, 0);
    EXPECT_THAT(chosen(), ElementsAre(1, 2));
    EXPECT_EQ(undoSteps(), 1U);
    EXPECT_EQ(session->document.history.undoName(), "Move 2 vertices");
    key('Z', {ctrl});
    expectCoord(1, 1, 0);
    clickAt(place("coord:2"));
    EXPECT_THAT(chosen(), ElementsAre(2)) << "a click chooses one of them alone";
}

TEST_F(PlaneInput, EscapeTakesADragBack) {
    const Scene before = scene();
    hold(place("coord:2"), {40, 0});
    EXPECT_NE(scene(), before);
    key(key::escape);
    ImGui::GetIO().MousePos.x += 40;
    frames(2);
    release();
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canRedo());
    key('Y', {ctrl});
    EXPECT_EQ(scene(), before);
}

TEST_F(PlaneInput, AClickThatTremblesMovesNothing) {
    const Scene before = scene();
    drag(place("coord:2"), {2, 1});
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(session->look.selection.vertex, 2U);
}

// A scale by 1/2 maps (1, 1) to (0.5, 0.5): a drag changes the coordinate by twice its distance.
TEST_F(PlaneInput, WhereACoordinateEndsCanBeDragged) {
    unit().matrix = {{.op = MatrixOp::Scale, .amount = {0.5F, 0.5F, 1}}};
    frames(2);
    expectPlace("end:2", 0.5F, 0.5F);
    expectPlace("coord:2", 1, 1);
    const float unitPixels = pixelsPerUnit();
    drag(place("end:2"), {40, 10});
    expectCoord(2, 1 + 2 * 40 / unitPixels, 1 - 2 * 10 / unitPixels);
    EXPECT_EQ(undoSteps(), 1U);
    drag(place("coord:1"), {0, 20});
    expectCoord(1, 1, -20 / unitPixels);
}

// x = 0.5 s, y = t, w = 1 + 0.5 s: the end point x has the coordinate s = x / (0.5 - 0.5 x).
TEST_F(PlaneInput, TheDivisionByQIsTakenBack) {
    glm::mat4 matrix(1);
    matrix[0][0] = 0.5F;
    matrix[0][3] = 0.5F;
    unit().matrix = {{.op = MatrixOp::Load, .matrix = matrix}};
    frames(2);
    expectPlace("end:2", 1 / 3.0F, 2 / 3.0F);
    const float unitPixels = pixelsPerUnit();
    drag(place("end:2"), {-20, 0});
    const float x = 1 / 3.0F - 20 / unitPixels;
    const float s = x / (0.5F - 0.5F * x);
    expectCoord(2, s, 2 / 3.0F * (1 + 0.5F * s));
}

TEST_F(PlaneInput, AGivenQDivides) {
    scene().models[0].texCoords[0] = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 2}, {0, 1, 0, 1}};
    frames(2);
    EXPECT_NEAR(place("end:2").x, at(0.5F, 0.5F).x, 0.5F);
    EXPECT_EQ(noted("legend:as given"), "legend:as given");
}

TEST_F(PlaneInput, OutlinesMoveWithTheScenesTime) {
    unit().matrix = {{.op = MatrixOp::Translate, .rate = {0.25F, 0, 0}}};
    session->look.playback.playing = false;
    session->look.playback.time = 0;
    frames(2);
    EXPECT_EQ(noted("legend:as given"), "") << "both are the same";
    session->look.playback.time = 2;
    frames(2);
    EXPECT_NEAR(place("end:0").x, at(0.5F, 0).x, 0.5F);
    EXPECT_NEAR(place("coord:0").x, at(0, 0).x, 0.5F);
}

TEST_F(PlaneInput, SaysWhyWhatIsGeneratedCannotBeMoved) {
    unit().texGenS = {.enabled = true, .mode = TexGenMode::ObjectLinear, .objectPlane = {1, 0, 0, 0}};
    frames(2);
    // The square reaches from -1 to 1.
    EXPECT_NEAR(place("end:2").x, at(1, 1).x, 0.5F);
    session->look.plane = {0, 0.5F, 3};
    frames(2);
    const Scene before = scene();
    EXPECT_NEAR(place("end:0").x, at(-1, 0).x, 0.5F);
    hold(place("end:0"), {0, -40});
    EXPECT_EQ(noted("refusal:"),
              "refusal:s is generated (GL_OBJECT_LINEAR): the given coordinate has no effect");
    release();
    EXPECT_EQ(noted("refusal:"), "");
    EXPECT_EQ(scene(), before);
}

TEST_F(PlaneInput, AVertexWithoutGlTexCoordEndsWhereTheOneBeforeItDoes) {
    scene().models[0].noTexCoord[0] = {0, 2};
    session->look.selection.vertex = 2;
    frames(2);
    expectPlace("coord:2", 1, 0);
    expectPlace("end:2", 1, 0);
    expectPlace("end:0", 0, 0);
    EXPECT_EQ(noted("coord label:"), "coord label:2 = 1   (1.00, 0.00)");
    EXPECT_EQ(noted("legend:as given"), "") << "the same as the resulting ones";
    const Scene before = scene();
    hold(place("end:2"), {40, 0});
    EXPECT_EQ(noted("refusal:"), "refusal:glTexCoord of vertex 2 is left out: its coordinate has no effect");
    release();
    key(key::right);
    EXPECT_EQ(session->look.notice.text, "glTexCoord of vertex 2 is left out: its coordinate has no effect");
    EXPECT_EQ(scene(), before);
    // Vertex 2 is drawn twice, the second time after 3.
    ASSERT_TRUE(turnIntoMesh(scene().models[0]));
    scene().models[0].mesh.primitive = Primitive::Triangles;
    scene().models[0].mesh.indices = {0, 1, 2, 0, 3, 2};
    frames(2);
    EXPECT_EQ(state().coords.outlinePlaces().back(), glm::vec2(0, 1));
    expectPlace("end:2", 1, 0);
}

TEST_F(PlaneInput, VerticesWithoutGlTexCoordStayWhenOthersAreMirrored) {
    scene().models[0].noTexCoord[0] = {0, 2};
    frames(2);
    mirrorVertices(*session, state().coords, 0);
    frames(2);
    const TexCoords& list = scene().models[0].texCoords[0];
    ASSERT_EQ(list.size(), 4U);
    EXPECT_EQ(glm::vec2(list[0]), glm::vec2(0, 0));
    EXPECT_EQ(glm::vec2(list[1]), glm::vec2(0, 0));
    EXPECT_EQ(glm::vec2(list[2]), glm::vec2(1, 1));
    EXPECT_EQ(glm::vec2(list[3]), glm::vec2(1, 1));
}

TEST_F(PlaneInput, SaysWhereTheMatrixHasNoInverse) {
    unit().matrix = {{.op = MatrixOp::Scale, .amount = {0, 1, 1}}};
    frames(2);
    const Scene before = scene();
    hold(place("end:2"), {40, 0});
    EXPECT_EQ(session->look.selection.vertex, 2U);
    EXPECT_EQ(noted("refusal:"),
              "refusal:the texture matrix has no inverse: it maps many coordinates to one place");
    release();
    EXPECT_EQ(scene(), before);
}

TEST_F(PlaneInput, GMovesUntilEnter) {
    grab();
    EXPECT_NE(noted("move hint:Moving 1"), "");
    moveTo(at(0.75F, 0.6F));
    expectCoord(2, 1.25F, 1.1F, 0.01F);
    key('S');
    moveTo(at(0.7F, 0.7F));
    expectCoord(2, 1.2F, 1, 0.01F);
    key(key::enter);
    moveTo(at(0.2F, 0.2F));
    expectCoord(2, 1.2F, 1, 0.01F);
    EXPECT_EQ(undoSteps(), 1U);
}

// It would add an undo step during the move.
TEST_F(PlaneInput, AnImageThatArrivesWaitsForTheEndOfAMove) {
    const TempDir folder;
    const std::filesystem::path file = folder.path() / "two.png";
    ASSERT_TRUE(writeFileAtomically(file, encodePng(drawPattern(Pattern::Checker)).value()));
    grab();
    moveTo(at(0.75F, 0.6F));
    importImage(*session, file);
    frames(3);
    ASSERT_TRUE(state().move.has_value());
    EXPECT_EQ(texture().source, SourceKind::Pattern);
    moveTo(at(0.7F, 0.7F));
    expectCoord(2, 1.2F, 1.2F, 0.01F);
    key(key::enter);
    frames(3);
    EXPECT_EQ(texture().source, SourceKind::File);
    EXPECT_EQ(undoSteps(), 2U);
    take(*session, Undo{});
    expectCoord(2, 1.2F, 1.2F, 0.01F);
    take(*session, Undo{});
    expectCoord(2, 1, 1);
}

TEST_F(PlaneInput, EscapeTakesAKeyedMoveBackAndNothingElse) {
    session->look.explaining.pixel = {5, 5};
    const Scene before = scene();
    grab();
    moveTo(at(0.75F, 0.6F));
    EXPECT_NE(scene(), before);
    key('T'); // t alone: a shortcut elsewhere
    key(key::escape);
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(undoSteps(), 0U);
    EXPECT_TRUE(session->look.explaining.pixel.has_value());
    key('G');
    moveTo(at(0.6F, 0.6F));
    clickAt(at(0.6F, 0.6F), ImGuiMouseButton_Right);
    EXPECT_EQ(scene(), before);
}

TEST_F(PlaneInput, AClickKeepsAKeyedMoveAndWhatIsChosen) {
    grab();
    clickAt(at(0.75F, 0.5F));
    expectCoord(2, 1.25F, 1, 0.01F);
    EXPECT_THAT(chosen(), ElementsAre(2));
    EXPECT_FALSE(state().move.has_value());
}

// By a quarter turn counter-clockwise about (0.5, 0.5): (0, 0) becomes (1, 0), (1, 0) becomes (1, 1).
TEST_F(PlaneInput, RTurnsAboutTheMiddle) {
    moveTo(at(1, 0.5F));
    key('A');
    EXPECT_THAT(chosen(), ElementsAre(0, 1, 2, 3));
    key('R');
    moveTo(at(0.5F, 1));
    key(key::enter);
    expectCoord(0, 1, 0, 0.01F);
    expectCoord(1, 1, 1, 0.01F);
    EXPECT_EQ(session->document.history.undoName(), "Rotate 4 vertices");
    key('A');
    EXPECT_THAT(chosen(), IsEmpty());
}

TEST_F(PlaneInput, SScalesAboutTheMiddleAndAlongOneAxis) {
    moveTo(at(0.75F, 0.5F));
    key('A');
    key('S');
    moveTo(at(1, 0.5F));
    expectCoord(0, -0.5F, -0.5F, 0.02F);
    key('Y');
    frames(1);
    expectCoord(0, 0, -0.5F, 0.02F);
    key(key::enter);
    expectCoord(2, 1, 1.5F, 0.02F);
}

TEST_F(PlaneInput, ArrowsMoveByATexelOrAQuarter) {
    clickAt(place("coord:2"));
    key(key::right);
    expectCoord(2, 1 + 1 / 64.0F, 1);
    key(key::down, {shift});
    expectCoord(2, 1 + 1 / 64.0F, 0.75F);
    EXPECT_EQ(undoSteps(), 2U);
}

TEST_F(PlaneInput, KeysCountOnlyOverThePanel) {
    clickAt(place("coord:2"));
    const Scene before = scene();
    moveTo(place("view"));
    for (const int code : {int{'G'}, int{'R'}, int{'S'}, key::left, key::up})
        key(code);
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(state().move.has_value());
    moveTo(at(0.5F, 0.5F));
    session->look.plane.extent = 20;
    key('F');
    EXPECT_NEAR(session->look.plane.extent, 1.4F, 1e-5F);
    EXPECT_EQ(scene(), before) << "F frames the models over the view alone";
}

TEST_F(PlaneInput, VerticesSnapAndCtrlInvertsIt) {
    state().snapping = {true, Snap::Quarter};
    const float unit = pixelsPerUnit();
    drag(place("coord:2"), {0.3F * unit, -0.1F * unit});
    expectCoord(2, 1.25F, 1, 1e-6F);
    {
        const Held held(*this, ctrl);
        drag(place("coord:0"), {0.1F * unit, -0.1F * unit});
    }
    expectCoord(0, 0.1F, 0.1F, 0.01F);
    state().snapping = {false, Snap::Texel};
    const Held held(*this, ctrl);
    drag(place("coord:1"), {0.1F * unit, 0});
    EXPECT_NEAR(coord(1).s * 64, std::round(coord(1).s * 64), 1e-4F);
    EXPECT_NEAR(coord(1).s, 1.1F, 0.01F);
}

TEST_F(PlaneInput, ASnapIsToTheNearest) {
    const auto to = [](glm::vec2 place, Snap snap) { return snapped(place, snap, {8, 4}, 0.1F); };
    EXPECT_EQ(to({0.3F, 0.3F}, Snap::Texel), glm::vec2(0.25F, 0.25F));
    EXPECT_EQ(to({0.35F, 0.4F}, Snap::Texel), glm::vec2(0.375F, 0.5F));
    EXPECT_EQ(to({-0.3F, 1.9F}, Snap::Quarter), glm::vec2(-0.25F, 2));
    EXPECT_EQ(to({0.05F, 0.5F}, Snap::Whole), glm::vec2(0, 0.5F));
    EXPECT_EQ(to({1.08F, -0.2F}, Snap::Whole), glm::vec2(1, -0.2F));
}

TEST_F(PlaneInput, HoveringAVertexRingsItInBothViews) {
    moveTo(place("coord:2"));
    EXPECT_EQ(session->look.hoveredInPlane, (PickedVertex{0, 2}));
    frames(1);
    ASSERT_TRUE(has("hovered vertex")) << "in the view";
    EXPECT_EQ(noted("coord label:2"), "coord label:2   (1.00, 1.00)");
    const ImVec2 inView = place("hovered vertex");
    moveTo(inView);
    EXPECT_EQ(session->look.hoveredInPlane, std::nullopt);
    EXPECT_EQ(session->look.hoveredInView, (PickedVertex{0, 2}));
    frames(1);
    ASSERT_TRUE(has("hover ring")) << "in the texture space";
    EXPECT_NEAR(place("hover ring").x, at(1, 1).x, 0.5F);
    moveTo(place("texture space"));
    frames(1);
    EXPECT_FALSE(has("hover ring"));
    EXPECT_FALSE(has("hovered vertex"));
}

TEST_F(PlaneInput, ShiftAddsInTheViewToo) {
    moveTo(place("coord:2"));
    frames(1);
    const ImVec2 two = place("hovered vertex");
    moveTo(place("coord:0"));
    frames(1);
    const ImVec2 zero = place("hovered vertex");
    clickAt(two);
    EXPECT_THAT(chosen(), ElementsAre(2));
    const Held shifted(*this, shift);
    clickAt(zero);
    EXPECT_THAT(chosen(), ElementsAre(0, 2));
}

TEST_F(PlaneInput, NumbersNameTheVertices) {
    for (const char* name : {"vertex number:0", "vertex number:1", "vertex number:2", "vertex number:3"})
        EXPECT_TRUE(has(name)) << name;
    clickAt(place("coord:2"));
    EXPECT_FALSE(has("vertex number:2"));
    EXPECT_EQ(noted("coord label:"), "coord label:2   (1.00, 1.00)");
    unit().matrix = {{.op = MatrixOp::Scale, .amount = {0.5F, 0.5F, 1}}};
    frames(2);
    EXPECT_EQ(noted("coord label:"), "coord label:2   (1.00, 1.00) → (0.50, 0.50)");
}

// The step is an ordinary one: an edit from elsewhere during a drag does not end the program.
TEST_F(PlaneInput, AMoveOfWhatIsGoneEndsWithoutACrash) {
    clickAt(place("coord:3"));
    moveTo(at(0.5F, 0.5F));
    key('G');
    scene().models[0].shape = Shape::Mesh;
    scene().models[0].mesh = {.primitive = Primitive::Triangles,
                              .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    frames(2);
    moveTo(at(0.7F, 0.7F));
    EXPECT_FALSE(state().move.has_value());
}

} // namespace
} // namespace texplorer::ui::plane_input_test
