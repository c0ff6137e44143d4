#include "texplorer/scene/references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace texplorer::references_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> pathsOf(const Scene& scene) {
    std::vector<std::string> paths;
    for (const KeyFrame& key : scene.timeline.keys)
        paths.push_back(key.path);
    return paths;
}

/// A pass for each way to name models.
class NamedModels : public testing::Test {
protected:
    NamedModels() {
        scene.models.resize(4);
        scene.passes.resize(4);
        scene.passes[1].models = {2};
        scene.passes[2].models = {3, 1, 2};
        scene.passes[3].models = {0};
    }
    Scene scene;
};

TEST_F(NamedModels, StayThemselvesAfterRemove) {
    renumber(scene, "models", afterRemove(1));
    EXPECT_THAT(scene.passes[0].models, IsEmpty());
    EXPECT_THAT(scene.passes[1].models, ElementsAre(1));
    EXPECT_THAT(scene.passes[2].models, ElementsAre(2, 1));
    EXPECT_THAT(scene.passes[3].models, ElementsAre(0));
    for (const Pass& pass : scene.passes)
        EXPECT_TRUE(pass.enabled);
}

// An empty list would mean all models.
TEST_F(NamedModels, DisableAPassThatNamedOnlyTheRemovedOne) {
    renumber(scene, "models", afterRemove(2));
    EXPECT_TRUE(scene.passes[0].enabled);
    EXPECT_FALSE(scene.passes[1].enabled);
    EXPECT_THAT(scene.passes[1].models, IsEmpty());
    EXPECT_TRUE(scene.passes[2].enabled);
    EXPECT_THAT(scene.passes[2].models, ElementsAre(2, 1));
}

TEST_F(NamedModels, StayThemselvesAfterInsert) {
    renumber(scene, "models", afterInsert(2));
    EXPECT_THAT(scene.passes[0].models, IsEmpty());
    EXPECT_THAT(scene.passes[1].models, ElementsAre(3));
    EXPECT_THAT(scene.passes[2].models, ElementsAre(4, 1, 3));
    EXPECT_THAT(scene.passes[3].models, ElementsAre(0));
}

TEST_F(NamedModels, StayThemselvesAfterMove) {
    renumber(scene, "models", afterMove(0, 2)); // 1 and 2 have moved down
    EXPECT_THAT(scene.passes[1].models, ElementsAre(1));
    EXPECT_THAT(scene.passes[2].models, ElementsAre(3, 0, 1));
    EXPECT_THAT(scene.passes[3].models, ElementsAre(2));
    renumber(scene, "models", afterMove(2, 0));
    EXPECT_THAT(scene.passes[2].models, ElementsAre(3, 1, 2));
}

TEST(Renumber, UnitsShowTheSameTextures) {
    Scene scene;
    scene.textures.resize(2);
    scene.passes.resize(1);
    std::array<Unit, maxUnits>& units = scene.passes[0].units;
    for (int i = 0; i < 3; ++i)
        units[static_cast<std::size_t>(i)].texture = i;
    renumber(scene, "textures", afterRemove(1)); // of three
    EXPECT_EQ(units[0].texture, 0);
    EXPECT_EQ(units[1].texture, 0) << "the one before the removed one";
    EXPECT_EQ(units[2].texture, 1);
    scene.textures.clear();
    units[0].enabled = true;
    renumber(scene, "textures", afterRemove(0));
    EXPECT_FALSE(units[0].enabled) << "there is none";
}

TEST(Renumber, KeyFramesFollowTheElementsOfTheirLists) {
    Scene start;
    start.timeline.keys = {{0, "textures[0].lodBias"},
                           {0, "textures[1].lodBias"},
                           {0, "textures[10].lodBias"},
                           {0, "texturesX[1].lodBias"},
                           {0, "passes[1].units[0].matrix[1].angle"},
                           {0, "view.azimuth"}};
    Scene removed = start;
    renumber(removed, "textures", afterRemove(1));
    EXPECT_THAT(pathsOf(removed),
                ElementsAre("textures[0].lodBias", "textures[9].lodBias", "texturesX[1].lodBias",
                            "passes[1].units[0].matrix[1].angle", "view.azimuth"));
    Scene inserted = start;
    renumber(inserted, "passes", afterInsert(0));
    EXPECT_EQ(inserted.timeline.keys[4].path, "passes[2].units[0].matrix[1].angle");
    EXPECT_EQ(inserted.timeline.keys[1].path, "textures[1].lodBias");
    Scene moved = start;
    renumber(moved, "passes[1].units[0].matrix", afterMove(1, 2));
    EXPECT_EQ(moved.timeline.keys[4].path, "passes[1].units[0].matrix[2].angle");
    Scene ofModels;
    ofModels.timeline.keys = {{0, "models[1].units[2].matrix[0].angle"}};
    renumber(ofModels, "models", afterInsert(0));
    renumber(ofModels, "models[2].units[2].matrix", afterMove(0, 3));
    EXPECT_THAT(pathsOf(ofModels), ElementsAre("models[2].units[2].matrix[3].angle"));
}

TEST(Renumber, ValuesOfKeyFramesNameTheSameElements) {
    Scene scene;
    scene.textures.resize(3);
    scene.models.resize(3);
    scene.timeline.keys = {{0, "passes[0].units[1].texture", "2"},
                           {1, "passes[0].units[1].texture", "0"},
                           {0, "passes[0].models", "2,0"},
                           {1, "passes[0].models", "1"},
                           {2, "passes[0].name", "2"}};
    renumber(scene, "textures", afterMove(2, 0));
    EXPECT_EQ(scene.timeline.keys[0].value, "0");
    EXPECT_EQ(scene.timeline.keys[1].value, "1");
    EXPECT_EQ(scene.timeline.keys[2].value, "2,0");
    renumber(scene, "models", afterRemove(1));
    ASSERT_EQ(scene.timeline.keys.size(), 4U) << "without the key that named only the removed model";
    EXPECT_EQ(scene.timeline.keys[2].value, "1,0");
    EXPECT_EQ(scene.timeline.keys[3].value, "2");
}

} // namespace
} // namespace texplorer::references_test
