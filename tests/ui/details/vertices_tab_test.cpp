#include "tests/ui/workbench.h"
#include "texplorer/scene/model_mesh.h"

#include <algorithm>

namespace texplorer::ui::vertices_tab_test {
namespace {

using namespace test;

class VerticesTab : public Workbench {
protected:
    void SetUp() override { putListRight(); }

    MeshData& mesh() { return scene().models[0].mesh; }

    /// A mesh with so many vertices in a row, as points.
    void startWithPoints(int count) {
        Scene points = scene();
        points.models.assign(1, Model{.shape = Shape::Mesh});
        points.models[0].mesh.primitive = Primitive::Points;
        for (int i = 0; i < count; ++i)
            points.models[0].mesh.positions.emplace_back(static_cast<float>(i) / static_cast<float>(count), 0,
                                                         0);
        start(points);
        putListRight();
    }
};

TEST_F(VerticesTab, ACubeBecomesAMeshWhoseCornersCanBeMoved) {
    EXPECT_FALSE(has("show Position"));
    session->settings.workspace.maximised = Maximised::Right; // room for the list
    frames(3);
    click("make mesh");
    EXPECT_EQ(scene().models[0].shape, Shape::Mesh);
    ASSERT_EQ(mesh().positions.size(), 24U);
    const glm::vec3 before = mesh().positions[2];
    const auto countAt = [&](glm::vec3 place) { return std::ranges::count(mesh().positions, place); };
    EXPECT_EQ(countAt(before), 3);
    drag(place("models[0].mesh.positions[2][0]"), {40, 0});
    const glm::vec3 after = mesh().positions[2];
    EXPECT_NEAR(after.x, before.x + 0.4F, 0.011F);
    EXPECT_EQ(after.y, before.y);
    EXPECT_EQ(countAt(after), 3) << "of the other two faces";
    EXPECT_EQ(session->look.selection.vertex, std::optional<std::size_t>(2));
    click("move together");
    drag(place("models[0].mesh.positions[2][1]"), {30, 0});
    EXPECT_EQ(countAt(after), 2);
    key('Z', {ctrl});
    key('Z', {ctrl});
    EXPECT_EQ(countAt(before), 3) << "each drag is a step";
    key('Z', {ctrl});
    EXPECT_EQ(scene().models[0].shape, Shape::Cube);
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(VerticesTab, GlTexCoordOfAVertexIsLeftOutAndSentAgain) {
    session->settings.workspace.maximised = Maximised::Right;
    frames(3);
    click("glTexCoord:2");
    EXPECT_EQ(scene().models[0].noTexCoord[0], std::vector<int>{2});
    EXPECT_EQ(scene().models[0].noTexCoord[1], std::vector<int>{});
    EXPECT_EQ(session->look.selection.vertex, std::optional<std::size_t>(2));
    click("glTexCoord:1");
    EXPECT_EQ(scene().models[0].noTexCoord[0], (std::vector<int>{1, 2}));
    drag(place("models[0].texCoords0[2][0]"), {40, 0}); // its coordinates are kept
    EXPECT_EQ(scene().models[0].texCoords[0].size(), 24U);
    click("glTexCoord:1");
    EXPECT_EQ(scene().models[0].noTexCoord[0], std::vector<int>{2});
    key('Z', {ctrl});
    EXPECT_EQ(scene().models[0].noTexCoord[0], (std::vector<int>{1, 2}));
    scene().models[0].noTexCoord[1] = {3};
    click("coords:Reset");
    EXPECT_TRUE(scene().models[0].texCoords[0].empty());
    EXPECT_EQ(scene().models[0].noTexCoord[0], std::vector<int>{});
    EXPECT_EQ(scene().models[0].noTexCoord[1], std::vector<int>{3}) << "of another unit";
    click("make mesh");
    click("show Position");
    EXPECT_FALSE(has("glTexCoord:1"));
}

TEST_F(VerticesTab, AModelsNameIsShownWholeWhereThereIsRoom) {
    scene().models[0].name = "A quad with t upwards";
    session->settings.workspace.maximised = Maximised::Right;
    frames(3);
    EXPECT_TRUE(has("model choice:0  A quad with t upwards"));
    scene().models[0].name = std::string(200, 'n');
    frames(3);
    const auto shown = places.items.lower_bound("model choice:0  n");
    ASSERT_TRUE(shown != places.items.end() && shown->first.starts_with("model choice:0  n"));
    EXPECT_TRUE(shown->first.ends_with("…")) << "what has no room is not cut silently";
    EXPECT_LT(shown->second.right, place("show r, q").x);
}

TEST_F(VerticesTab, AShapeThatIsTooLargeSaysSo) {
    scene().models[0].shape = Shape::Sphere;
    scene().models[0].slices = 256;
    scene().models[0].stacks = 256;
    frames(2);
    click("make mesh");
    EXPECT_EQ(scene().models[0].shape, Shape::Sphere);
    EXPECT_EQ(session->look.notice.text, "the sphere has 66049 vertices, a mesh has at most 65536");
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(VerticesTab, VerticesAreAddedDuplicatedAndRemoved) {
    startWithPoints(3);
    click("show Position");
    click("add vertex");
    ASSERT_EQ(mesh().positions.size(), 4U);
    EXPECT_EQ(mesh().positions[3], mesh().positions[2]);
    EXPECT_EQ(session->look.selection.vertex, std::optional<std::size_t>(3));
    frames(2);
    click("vertex:0");
    click("duplicate vertex");
    ASSERT_EQ(mesh().positions.size(), 5U);
    EXPECT_EQ(mesh().positions[1], mesh().positions[0]);
    EXPECT_EQ(session->look.selection.vertex, std::optional<std::size_t>(1));
    for (int left = 4; left >= 0; --left) {
        click("remove vertex");
        ASSERT_EQ(mesh().positions.size(), static_cast<std::size_t>(left));
    }
    EXPECT_FALSE(session->look.selection.vertex.has_value());
    click("remove vertex"); // which is off
    click("add vertex");
    EXPECT_EQ(mesh().positions.size(), 1U);
    for (int steps = 0; steps < 8; ++steps)
        key('Z', {ctrl});
    EXPECT_EQ(mesh().positions.size(), 3U);
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(VerticesTab, NormalsAndColoursBeginAsTheyWereAndCanBeTakenAway) {
    startWithPoints(3);
    scene().material.color = {0.5F, 0.25F, 1, 1};
    click("show Normal");
    drag(place("models[0].mesh.normals[1][0]"), {40, 0});
    ASSERT_EQ(mesh().normals.size(), 3U);
    EXPECT_NEAR(mesh().normals[1].x, 0.2F, 0.006F);
    EXPECT_EQ(mesh().normals[1].z, 1);
    EXPECT_EQ(mesh().normals[2], glm::vec3(0, 0, 1));
    click("clear Normal");
    EXPECT_TRUE(mesh().normals.empty());
    click("show Colour");
    drag(place("models[0].mesh.colors[0][0]"), {40, 0});
    ASSERT_EQ(mesh().colors.size(), 3U);
    EXPECT_NEAR(mesh().colors[0].r, 0.7F, 0.006F);
    EXPECT_EQ(mesh().colors[2], glm::vec4(0.5F, 0.25F, 1, 1));
    click("clear Colour");
    EXPECT_TRUE(mesh().colors.empty());
}

TEST_F(VerticesTab, VerticesThatCompleteNoPartAreListed) {
    startWithPoints(4);
    mesh().primitive = Primitive::Triangles;
    frames(2);
    EXPECT_TRUE(has("face:Triangle 1"));
    EXPECT_TRUE(has("face:Not drawn"));
    EXPECT_TRUE(has("vertex:3"));
}

TEST_F(VerticesTab, OfALongListOnlyWhatOneSeesIsDrawn) {
    startWithPoints(static_cast<int>(maxMeshVertices));
    session->settings.workspace.maximised = Maximised::Right; // room for the list
    frames(3);
    const auto rows = [&] {
        return std::ranges::count_if(places.items,
                                     [](const auto& item) { return item.first.starts_with("vertex:"); });
    };
    EXPECT_GT(rows(), 3);
    EXPECT_LT(rows(), 100);
    EXPECT_TRUE(has("vertex:0"));
    session->look.selection.vertex = 40000; // as a click in the view would
    frames(3);
    ASSERT_TRUE(has("vertex:40000"));
    EXPECT_TRUE(places.items.at("vertex:40000").visible);
    EXPECT_LT(rows(), 100);
}

// A colour alone says nothing to who doesn't see it.
TEST_F(VerticesTab, TheLetterOfACoordinateStandsBesideItsColour) {
    frames(2);
    EXPECT_TRUE(has("field letter:s"));
    EXPECT_TRUE(has("field letter:t"));
    EXPECT_FALSE(has("field letter:q"));
    click("show r, q");
    EXPECT_TRUE(has("field letter:q"));
}

} // namespace
} // namespace texplorer::ui::vertices_tab_test
