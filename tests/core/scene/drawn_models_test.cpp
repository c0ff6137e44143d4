#include "texplorer/scene/drawn_models.h"

#include <gmock/gmock.h>

namespace texplorer::drawn_models_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Four models; the second one is invisible.
class DrawnModels : public testing::Test {
protected:
    DrawnModels() {
        scene.models.resize(4);
        scene.models[1].visible = false;
    }
    [[nodiscard]] Pass& pass() { return scene.passes[0]; }

    Scene scene;
};

TEST_F(DrawnModels, AreAllWhereThePassNamesNone) {
    EXPECT_THAT(drawnModels(scene, pass()), ElementsAre(0, 2, 3));
}

TEST_F(DrawnModels, AreThoseThatThePassNamesInItsOrder) {
    pass().models = {3, 1, 0};
    EXPECT_THAT(drawnModels(scene, pass()), ElementsAre(3, 0));
    pass().models = {1};
    EXPECT_THAT(drawnModels(scene, pass()), IsEmpty());
}

TEST_F(DrawnModels, AreNoneWhereThePassIsOff) {
    pass().enabled = false;
    EXPECT_THAT(drawnModels(scene, pass()), IsEmpty());
    pass().models = {0};
    EXPECT_THAT(drawnModels(scene, pass()), IsEmpty());
}

// A scene that was not validated.
TEST_F(DrawnModels, AreNotThoseThatThereAreNot) {
    pass().models = {4, -1, 2, 1000};
    EXPECT_THAT(drawnModels(scene, pass()), ElementsAre(2));
}

TEST_F(DrawnModels, AreDrawnByAnyPass) {
    pass().models = {0};
    scene.passes.emplace_back().models = {1, 2};
    scene.passes.emplace_back().models = {3};
    scene.passes[2].enabled = false;
    EXPECT_TRUE(isDrawn(scene, 0));
    EXPECT_FALSE(isDrawn(scene, 1)) << "invisible";
    EXPECT_TRUE(isDrawn(scene, 2));
    EXPECT_FALSE(isDrawn(scene, 3)) << "by a pass alone that is off";
    EXPECT_FALSE(isDrawn(scene, 4));
    EXPECT_TRUE(drawsAnything(scene, scene.passes[0]));
    EXPECT_TRUE(drawsAnything(scene, scene.passes[1]));
    EXPECT_FALSE(drawsAnything(scene, scene.passes[2]));
    scene.passes[1].models = {1};
    EXPECT_FALSE(drawsAnything(scene, scene.passes[1]));
    scene.models.clear();
    EXPECT_FALSE(drawsAnything(scene, scene.passes[0]));
}

TEST(DrawEverywhere, AddsAModelToThePassesThatNameTheirs) {
    Scene scene;
    scene.models.resize(4);
    scene.passes.resize(4);
    scene.passes[1].models = {2};
    scene.passes[2].models = {3, 1, 2};
    scene.passes[3].models = {0};
    drawEverywhere(scene, 3);
    EXPECT_THAT(scene.passes[0].models, IsEmpty());
    EXPECT_THAT(scene.passes[1].models, ElementsAre(2, 3));
    EXPECT_THAT(scene.passes[2].models, ElementsAre(3, 1, 2));
    EXPECT_THAT(scene.passes[3].models, ElementsAre(0, 3));
}

TEST(NameOfAModel, IsItsOwnOrItsShapes) {
    EXPECT_EQ(nameOf(Model{.shape = Shape::PartialDisk}), "Partial disk");
    EXPECT_EQ(nameOf(Model{.name = "Roof", .shape = Shape::Mesh}), "Roof");
}

} // namespace
} // namespace texplorer::drawn_models_test
