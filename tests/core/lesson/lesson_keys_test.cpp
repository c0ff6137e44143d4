#include "texplorer/lesson/lesson_keys.h"

#include <gmock/gmock.h>

namespace texplorer::lesson::lesson_keys_test {
namespace {

using testing::ElementsAre;

/// Passes 0 and 1 are two ways to the same, 2 comes on top of them, 3 goes without.
std::vector<LessonKey> switches() {
    return {
        {"M", "way",
         Cycle{{{"a", {edit::Set{"passes[0].enabled", "true"}, edit::Set{"passes[1].enabled", "false"}}},
                {"b", {edit::Set{"passes[0].enabled", "false"}, edit::Set{"passes[1].enabled", "true"}}}}}},
        {"E", "top",
         Cycle{{{"on", {edit::Set{"passes[2].enabled", "true"}}},
                {"off", {edit::Set{"passes[2].enabled", "false"}}}}}},
        {"B", "all",
         Cycle{{{"on", {edit::Set{"passes[3].enabled", "false"}}},
                {"off",
                 {edit::Set{"passes[0].enabled", "false"}, edit::Set{"passes[1].enabled", "false"},
                  edit::Set{"passes[2].enabled", "false"}, edit::Set{"passes[3].enabled", "true"}}}}}},
        {"F", "filter",
         Cycle{{{"nearest", {edit::Set{"textures[0].magFilter", "GL_NEAREST"}}},
                {"linear", {edit::Set{"textures[0].magFilter", "GL_LINEAR"}}}}}},
        {"Up", "faster", Addition{"models[0].spin", 1, 0.5F}}};
}

Scene startScene() {
    Scene scene;
    scene.models.resize(1);
    scene.textures.resize(1);
    scene.passes.resize(4);
    scene.passes[1].enabled = false;
    scene.passes[3].enabled = false;
    return scene;
}

std::vector<bool> passesOf(const Scene& scene) {
    std::vector<bool> enabled;
    for (const Pass& pass : scene.passes)
        enabled.push_back(pass.enabled);
    return enabled;
}

class LessonKeys : public testing::Test {
protected:
    std::vector<LessonKey> keys = switches();
    Scene scene = startScene();
    ChosenChoices chosen = choicesOf(scene, keys, {});

    std::vector<bool> press(std::size_t key) {
        EXPECT_TRUE(pressKey(scene, keys, chosen, key));
        return passesOf(scene);
    }
};

/// NeHe 22: useMultitexture = !useMultitexture && multitextureSupported.
TEST_F(LessonKeys, PassOverWhatTakesMoreUnitsThanThereAre) {
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[1].enabled = true;
    scene.passes[1].units[0].enabled = true;
    ASSERT_TRUE(pressKey(scene, keys, chosen, 0, 1));
    EXPECT_THAT(passesOf(scene), ElementsAre(false, true, true, false));
    ASSERT_TRUE(pressKey(scene, keys, chosen, 0, 1));
    EXPECT_THAT(passesOf(scene), ElementsAre(false, true, true, false)) << "pass 0 takes two";
    ASSERT_TRUE(pressKey(scene, keys, chosen, 0, 2));
    EXPECT_THAT(passesOf(scene), ElementsAre(true, false, true, false));
}

TEST_F(LessonKeys, KnowWhichChoicesASceneHas) {
    EXPECT_THAT(chosen, ElementsAre(0, 0, 0, 1, 0)) << "GL_LINEAR is the initial value";
    scene.passes[0].enabled = false;
    scene.passes[1].enabled = true;
    scene.textures[0].magFilter = MagFilter::Nearest;
    EXPECT_THAT(choicesOf(scene, keys, chosen), ElementsAre(1, 0, 0, 0, 0));
    scene.passes[0].enabled = true; // what no choice has
    EXPECT_THAT(choicesOf(scene, keys, ChosenChoices{1, 1, 0, 0, 0}), ElementsAre(1, 1, 0, 0, 0));
}

TEST_F(LessonKeys, GoOnToTheNextChoiceAndBack) {
    EXPECT_THAT(press(0), ElementsAre(false, true, true, false));
    EXPECT_THAT(press(0), ElementsAre(true, false, true, false));
    press(3);
    EXPECT_EQ(scene.textures[0].magFilter, MagFilter::Nearest);
    press(3);
    EXPECT_EQ(scene, startScene());
}

TEST_F(LessonKeys, ALaterKeyHasTheLastWord) {
    EXPECT_THAT(press(2), ElementsAre(false, false, false, true));
    EXPECT_THAT(press(0), ElementsAre(false, false, false, true)) << "still off";
    EXPECT_THAT(press(1), ElementsAre(false, false, false, true));
    EXPECT_THAT(chosen, ElementsAre(1, 1, 1, 1, 0)) << "but remembered";
    EXPECT_THAT(press(2), ElementsAre(false, true, false, false));
}

TEST_F(LessonKeys, LeaveOtherParametersAlone) {
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.view.azimuth = 12;
    press(0);
    EXPECT_EQ(scene.textures[0].magFilter, MagFilter::Nearest);
    EXPECT_EQ(scene.view.azimuth, 12);
}

TEST_F(LessonKeys, AddToANumber) {
    const Addition& faster = std::get<Addition>(keys[4].effect);
    scene.models[0].spin = {1, 2, 3};
    ASSERT_TRUE(addTo(scene, faster, 3, 0));
    EXPECT_EQ(scene.models[0].spin, glm::vec3(1, 3.5F, 3));
    EXPECT_EQ(numberOf(scene, faster), 3.5F);
    const Addition nearer{"view.distance", 0, -1};
    scene.view.distance = 2;
    ASSERT_TRUE(addTo(scene, nearer, 1, 0));
    EXPECT_EQ(scene.view.distance, 1);
    EXPECT_FALSE(addTo(scene, nearer, 1, 0)) << "0.1 is the least";
    EXPECT_EQ(scene.view.distance, 1);
}

// 10 degrees + 2 a second for 5 s are 20; 0.5 a second faster, it is 10 - 2.5 at time 0.
TEST_F(LessonKeys, AModelDoesNotJumpAsItsSpinChanges) {
    scene.models[0].rotation = {7, 10, 0};
    scene.models[0].spin = {1, 2, 0};
    ASSERT_TRUE(addTo(scene, {"models[0].spin", 1, 0.5F}, 1, 5));
    EXPECT_EQ(scene.models[0].rotation, glm::vec3(7, 7.5F, 0));
    // 1000 s at 1 degree a second less: 1007 degrees, which are -73.
    ASSERT_TRUE(addTo(scene, {"models[0].spin", 0, -1}, 1, 1000));
    EXPECT_EQ(scene.models[0].rotation.x, -73);
}

TEST_F(LessonKeys, SayWhatASceneHasNot) {
    for (const LessonKey& key : keys)
        EXPECT_TRUE(checkKey(scene, key)) << key.key;
    scene.passes.resize(2);
    scene.models.clear();
    EXPECT_TRUE(checkKey(scene, keys[0]));
    EXPECT_EQ(checkKey(scene, keys[2]).error().where.text().substr(0, 18), "/cycle/0/edits/0: ");
    EXPECT_FALSE(checkKey(scene, keys[4]));
    EXPECT_FALSE(checkKey(startScene(), {"A", "x", Addition{"models[0].spin", 3, 1}})) << "a fourth of three";
    EXPECT_FALSE(checkKey(startScene(), {"A", "x", Addition{"passes[0].enabled", 0, 1}})) << "no number";
    EXPECT_FALSE(pressKey(scene, keys, chosen, 2));
}

} // namespace
} // namespace texplorer::lesson::lesson_keys_test
