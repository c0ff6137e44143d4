#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_diff.h"

#include <gmock/gmock.h>

#include <array>
#include <string>
#include <vector>

namespace texplorer::scene_diff_test {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

Scene withValue(const char* path, const char* text, Scene scene = defaultScene()) {
    const Result<void> done = setParam(scene, path, text);
    EXPECT_TRUE(done) << describe(done.error());
    return scene;
}

TEST(ChangesBetween, AreNoneOfTheSameScene) {
    EXPECT_THAT(changesBetween(defaultScene(), defaultScene()), IsEmpty());
    EXPECT_THAT(changesBetween(Scene{}, Scene{}), IsEmpty());
}

TEST(ChangesBetween, SayPathLabelAndBothValues) {
    EXPECT_THAT(changesBetween(defaultScene(), withValue("textures[0].wrapS", "GL_CLAMP")),
                ElementsAre(SceneChange{"textures[0].wrapS", "Wrap s", "GL_REPEAT", "GL_CLAMP"}));
    EXPECT_THAT(changesBetween(withValue("view.background", "1,0,0.5,1"), defaultScene()),
                ElementsAre(SceneChange{"view.background", "Background", "1,0,0.5,1", "0.11,0.13,0.16,1"}));
}

TEST(ChangesBetween, OfListsOfDifferentLengthsSayTheLengthsAndWhatIsInBoth) {
    const Scene one = defaultScene();
    Scene other = one;
    other.textures.resize(3);
    other.textures[0].border = 1;
    other.passes[0].units[1].matrix.resize(1);
    const std::vector<SceneChange> changes = changesBetween(one, other);
    EXPECT_THAT(changes, ElementsAre(SceneChange{"textures", "Texture", "1 element", "3 elements", true},
                                     Field(&SceneChange::path, "textures[0].border"),
                                     Field(&SceneChange::path, "passes[0].units[1].matrix")));
}

TEST(ChangesBetween, OfALongListSayTheFirstThatDiffers) {
    Scene one = defaultScene();
    one.models[0].texCoords[0].assign(24, glm::vec4(0, 0, 0, 1));
    Scene other = one;
    other.models[0].texCoords[0].edit()[7] = {0.25F, 2, 0, 1};
    EXPECT_THAT(changesBetween(one, other),
                ElementsAre(SceneChange{"models[0].texCoords0", "Unit 0", "[7] 0,0 of 24 elements",
                                        "[7] 0.25,2 of 24 elements"}));
    other.models[0].texCoords[0].clear();
    EXPECT_THAT(changesBetween(one, other),
                ElementsAre(testing::AllOf(Field(&SceneChange::from, "24 elements"),
                                           Field(&SceneChange::to, "0 elements"))));
}

Result<void> takeOverOne(Scene& scene, const Scene& from, const std::string& path) {
    return takeOver(scene, from, std::array{path});
}

/// All differences at once make the scenes equal.
void expectTakenOver(const Scene& from, Scene scene) {
    std::vector<std::string> paths;
    for (const SceneChange& each : changesBetween(from, scene))
        paths.push_back(each.path);
    ASSERT_TRUE(takeOver(scene, from, paths));
    EXPECT_THAT(changesBetween(from, scene), IsEmpty());
    EXPECT_EQ(scene, from);
}

TEST(TakeOver, OfEveryChangeMakesTheScenesTheSame) {
    Scene other = defaultScene();
    other.view.azimuth = 77;
    other.models.resize(4);
    other.models[3].shape = Shape::Torus;
    other.models[3].stacks = 7;
    other.textures.resize(2);
    other.textures[1].preparation.resize(2);
    other.textures[1].preparation[1].op = ImageOp::Invert;
    other.passes.resize(2);
    other.passes[1].units[3].matrix.resize(2);
    other.passes[1].units[3].matrix[1].amount = {1, 2, 3};
    other.passes[0].units[2].enabled = true;
    other.passes[0].units[2].texture = 1;
    expectTakenOver(defaultScene(), other);
    expectTakenOver(other, defaultScene());
}

TEST(TakeOver, OfALongerListCopiesWhatIsNew) {
    Scene from = defaultScene();
    from.textures.resize(2);
    from.textures[1].pattern = Pattern::Brick;
    from.textures[1].preparation.resize(1);
    from.textures[1].preparation[0].amount = 4;
    Scene scene = defaultScene();
    ASSERT_TRUE(takeOverOne(scene, from, "textures"));
    EXPECT_EQ(scene.textures, from.textures);
}

TEST(TakeOver, IsRefusedWhereTheSceneWouldNotFitTogether) {
    Scene from = defaultScene();
    Scene scene = from;
    scene.textures.resize(2);
    scene.passes[0].units[0].texture = 1;
    const Scene before = scene;
    const Result<void> taken = takeOverOne(scene, from, "textures");
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(taken.error().where, "textures");
    EXPECT_EQ(scene, before);
}

TEST(TakeOver, IsNotHeldUpByWhatDidNotFitBefore) {
    Scene scene = defaultScene();
    scene.models[0].texCoords[0].assign(5, glm::vec4(0, 0, 0, 1)); // of an earlier shape
    scene.view.azimuth = 77;
    ASSERT_TRUE(takeOverOne(scene, defaultScene(), "view.azimuth"));
    EXPECT_EQ(scene.view, defaultScene().view);
}

TEST(TakeOver, IsRefusedWhereThereIsNothingAtThePath) {
    Scene scene = defaultScene();
    for (const char* path : {"", "textures[7].wrapS", "nothing", "view"}) {
        const Result<void> taken = takeOverOne(scene, Scene{}, path);
        ASSERT_FALSE(taken) << path;
        EXPECT_EQ(taken.error().code, ErrorCode::NotFound) << path;
    }
    EXPECT_EQ(scene, defaultScene());
}

} // namespace
} // namespace texplorer::scene_diff_test
