#include "texplorer/scene/edit/edit.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace texplorer::edit_test {
namespace {

using testing::HasSubstr;

Scene threeOfEach() {
    Scene scene = defaultScene();
    scene.models.resize(3);
    scene.textures.resize(3);
    scene.passes.resize(3);
    for (std::size_t i = 0; i < 3; ++i) {
        scene.models[i].name = fmt::format("model {}", i);
        scene.textures[i].lodBias = static_cast<float>(i);
        scene.passes[i].name = fmt::format("pass {}", i);
        scene.passes[i].models = {static_cast<int>(2 - i)};
        scene.passes[i].units[0].texture = static_cast<int>(i);
        scene.passes[i].units[0].matrix.resize(2);
        scene.timeline.keys.push_back({0, fmt::format("textures[{}].priority", i), "1"});
    }
    return scene;
}

Scene after(Scene scene, const std::vector<Edit>& edits) {
    const Result<void> made = makeEdits(scene, edits);
    EXPECT_TRUE(made) << describe(made.error());
    return scene;
}

TEST(Edits, InsertANewElementOrACopy) {
    const Scene scene = after(threeOfEach(), {edit::Insert{"textures", 1}, edit::Insert{"models", 3, 0},
                                              edit::Insert{"passes[1].units[0].matrix", 2}});
    ASSERT_EQ(scene.textures.size(), 4U);
    EXPECT_EQ(scene.textures[1], Texture());
    EXPECT_EQ(scene.passes[2].units[0].texture, 3);
    EXPECT_EQ(scene.timeline.keys[2].path, "textures[3].priority");
    EXPECT_EQ(scene.models.at(3).name, "model 0");
    EXPECT_EQ(scene.passes[1].units[0].matrix.size(), 3U);
}

TEST(Edits, RemoveAndMove) {
    const Scene start = threeOfEach();
    const Scene removed = after(start, {edit::Remove{"models", 0}});
    EXPECT_EQ(removed.models.size(), 2U);
    EXPECT_EQ(removed.passes[0].models, std::vector{1});
    EXPECT_FALSE(removed.passes[2].enabled);
    const Scene moved = after(start, {edit::Move{"textures", 0, 2}});
    EXPECT_EQ(moved.textures[2], start.textures[0]);
    EXPECT_EQ(moved.textures[0], start.textures[1]);
    EXPECT_EQ(moved.passes[0].units[0].texture, 2);
    EXPECT_EQ(after(moved, {edit::Move{"textures", 2, 0}}), start);
}

TEST(Edits, SeeWhatThoseBeforeThemMade) {
    const Scene scene =
        after(threeOfEach(), {edit::Insert{"textures", 3}, edit::Set{"textures[3].lodBias", "4"},
                              edit::Set{"passes[0].units[0].texture", "3"}});
    EXPECT_EQ(scene.textures.at(3).lodBias, 4);
    EXPECT_EQ(scene.passes[0].units[0].texture, 3);
}

TEST(Edits, AreAllMadeOrNone) {
    struct Refusal {
        Edit edit;
        const char* message;
    };
    Scene full = threeOfEach();
    full.passes.resize(maxPasses);
    const Refusal refusals[] = {
        {edit::Set{"textures[9].lodBias", "1"}, "textures[9]"},
        {edit::Insert{"textures", 9},
         "textures: expected the index of one of 3 elements, counted from 0, found 9"},
        {edit::Insert{"textures", 0, 3}, "found 3"},
        {edit::Insert{"passes", 0}, "it already has"},
        {edit::Insert{"passes[0].units", 0}, "it always has"},
        {edit::Remove{"models", 3}, "found 3"},
        {edit::Move{"models", 0, 3}, "found 3"},
        {edit::Move{"view", 0, 0}, "view"},
        {edit::Remove{"nothing", 0}, "nothing: no such parameter"},
        {edit::Remove{"textures[0].wrapS", 0}, "it is no list"},
        {edit::Remove{"material.shininess", 0}, "it is no list"},
        {edit::ApplyPreset{"nothing"}, "nothing: there is no such preset"},
        {edit::ApplyPreset{"alpha-test", {.pass = 99}}, "there is no unit"},
    };
    for (const Refusal& each : refusals) {
        Scene scene = full;
        const std::vector<Edit> edits{edit::Set{"material.shininess", "5"}, each.edit};
        const Result<void> made = makeEdits(scene, edits, "edits");
        ASSERT_FALSE(made) << each.message;
        EXPECT_THAT(describe(made.error()), HasSubstr(each.message));
        EXPECT_THAT(describe(made.error()), HasSubstr("edits/1"));
        EXPECT_EQ(scene, full);
    }
    const Result<void> plain = makeEdits(full, std::vector<Edit>{edit::Remove{"nothing", 0}});
    EXPECT_EQ(plain.error().where, "nothing") << "without a place it is the edit's alone";
}

TEST(Edits, KeepWhatAListNeeds) {
    Scene scene = defaultScene();
    scene.passes.resize(1);
    EXPECT_FALSE(makeEdits(scene, std::vector<Edit>{edit::Remove{"passes", 0}}));
    EXPECT_EQ(scene.passes.size(), 1U);
}

TEST(Edits, AreWrittenAsTheyAreRead) {
    for (const char* text :
         {"textures[0].wrapS=GL_CLAMP", "models[0].name=a=b", "material.shininess=", "preset:seam"}) {
        const std::optional<Edit> edit = parseEdit(text);
        ASSERT_TRUE(edit) << text;
        EXPECT_EQ(textOf(*edit), text);
    }
    for (const char* text : {"", "=1", "preset:", "textures"})
        EXPECT_FALSE(parseEdit(text)) << text;
    EXPECT_EQ(pathOf(edit::Set{"a.b", "1"}), "a.b");
    EXPECT_EQ(pathOf(edit::ApplyPreset{"seam"}), "");
    EXPECT_EQ(textOf(edit::Remove{"models", 0}), "");
}

TEST(Edits, ReplaceAValueOrTheScene) {
    Scene other = threeOfEach();
    other.textures[1].wrapS = Wrap::Clamp;
    other.view.azimuth = 12;
    const auto from = std::make_shared<const Scene>(other);
    const Scene start = threeOfEach();
    const Scene one = after(start, {edit::Replace{from, {"textures[1].wrapS"}}});
    EXPECT_EQ(one.textures[1].wrapS, Wrap::Clamp);
    EXPECT_EQ(one.view, start.view);
    EXPECT_EQ(after(start, {edit::Replace{from}}), other);
    Scene refused = start;
    EXPECT_FALSE(makeEdits(refused, std::vector<Edit>{edit::Replace{from, {"textures[9].wrapS"}}}));
    EXPECT_EQ(refused, start);
}

TEST(Edits, MakeTheChangesOfAFunctionAtOnce) {
    const Scene start = threeOfEach();
    const auto change = [](Scene& scene) {
        scene.textures.resize(4); // a unit names it before the list has it
        scene.textures[3].wrapS = Wrap::Clamp;
        scene.passes[0].units[0].texture = 3;
        scene.models[0].texCoords[0].clear();
        scene.passes[0].units[0].matrix.resize(2);
        scene.passes[0].units[0].matrix[1].amount = {1, 2, 3};
    };
    Scene expected = start;
    change(expected);
    const std::optional<Edit> edit = editThat(start, change);
    ASSERT_TRUE(edit);
    EXPECT_EQ(after(start, {*edit}), expected);
    EXPECT_FALSE(editThat(start, [](Scene&) {}));
}

TEST(Edits, OfAFunctionRemoveTheKeysOfElementsThatItRemoves) {
    Scene scene = threeOfEach();
    scene.passes[0].units[0].matrix.resize(2);
    scene.timeline.keys = {{1, "passes[0].units[0].matrix[1].amount", "1,0,0"},
                           {1, "passes[0].units[0].matrix[0].amount", "2,0,0"},
                           {1, "view.azimuth", "10"}};
    const std::optional<Edit> edit = editThat(scene, [](Scene& changed) {
        changed.passes[0].units[0].matrix.resize(1);
        changed.view.azimuth = 20;
    });
    ASSERT_TRUE(edit);
    ASSERT_TRUE(makeEditsAt(scene, std::vector{*edit}, {.shown = 1, .key = 1}));
    ASSERT_EQ(scene.timeline.keys.size(), 2U);
    EXPECT_EQ(scene.timeline.keys[0].path, "passes[0].units[0].matrix[0].amount");
    EXPECT_EQ(scene.timeline.keys[1].value, "20");
}

// Edits of a scene whose key frames are shown at a time.

/// The material's shininess goes from 0 to 10 in 10 seconds; its own value is 3.
Scene moving() {
    Scene scene = threeOfEach();
    scene.material.shininess = 3;
    scene.timeline.keys = {{0, "material.shininess", "0"}, {10, "material.shininess", "10"}};
    return scene;
}

TEST(EditsAtATime, SetAKeyInsteadOfAValueThatHasKeys) {
    Scene scene = moving();
    const Result<bool> keyed =
        makeEditsAt(scene, std::vector<Edit>{edit::Set{"material.shininess", "7"}}, {.shown = 4, .key = 4});
    ASSERT_TRUE(keyed) << describe(keyed.error());
    EXPECT_TRUE(*keyed);
    EXPECT_EQ(scene.material.shininess, 3);
    ASSERT_EQ(scene.timeline.keys.size(), 3U);
    EXPECT_EQ(scene.timeline.keys[2].time, 4);
    EXPECT_EQ(scene.timeline.keys[2].value, "7");
}

TEST(EditsAtATime, SetNoKeyForTheShownValueOrAnother) {
    Scene scene = moving();
    const std::vector<Edit> edits{edit::Set{"material.shininess", "4"}, edit::Set{"view.azimuth", "20"}};
    const Result<bool> keyed = makeEditsAt(scene, edits, {.shown = 4, .key = 4});
    ASSERT_TRUE(keyed) << describe(keyed.error());
    EXPECT_FALSE(*keyed);
    EXPECT_EQ(scene.timeline, moving().timeline);
    EXPECT_EQ(scene.material.shininess, 3);
    EXPECT_EQ(scene.view.azimuth, 20);
}

TEST(EditsAtATime, SetTheKeyOfTheElementThatWasMovedBefore) {
    Scene scene = threeOfEach(); // each texture has a key of its priority
    const std::vector<Edit> edits{edit::Move{"textures", 0, 2}, edit::Set{"textures[2].priority", "0.5"}};
    const Result<bool> keyed = makeEditsAt(scene, edits, {.shown = 0, .key = 0});
    ASSERT_TRUE(keyed) << describe(keyed.error());
    EXPECT_TRUE(*keyed);
    Scene expected = threeOfEach();
    expected.timeline.keys[0].value = "0.5";
    ASSERT_TRUE(makeEdits(expected, std::vector<Edit>{edit::Move{"textures", 0, 2}}));
    EXPECT_EQ(scene, expected);
}

TEST(EditsAtATime, CopyAnElementAsItIsSeen) {
    Scene scene = threeOfEach();
    scene.timeline.keys = {{0, "textures[1].lodBias", "0"}, {10, "textures[1].lodBias", "10"}};
    const Result<bool> keyed =
        makeEditsAt(scene, std::vector<Edit>{edit::Insert{"textures", 3, 1}}, {.shown = 4, .key = 4});
    ASSERT_TRUE(keyed) << describe(keyed.error());
    EXPECT_EQ(scene.textures.at(3).lodBias, 4);
    EXPECT_EQ(scene.textures[1], threeOfEach().textures[1]);
    EXPECT_EQ(scene.timeline.keys.size(), 2U);
}

TEST(EditsAtATime, ReplaceTheSceneWithItsKeys) {
    Scene scene = moving();
    const auto from = std::make_shared<const Scene>(threeOfEach());
    const Result<bool> keyed =
        makeEditsAt(scene, std::vector<Edit>{edit::Replace{from}}, {.shown = 4, .key = 4});
    ASSERT_TRUE(keyed) << describe(keyed.error());
    EXPECT_FALSE(*keyed);
    EXPECT_EQ(scene, threeOfEach());
}

TEST(EditsAtATime, KeepTheShownValueOfAParameterThatHasNoKeyAnyMore) {
    Scene scene = moving();
    const std::optional<Edit> edit = editThat(scene, [](Scene& changed) { changed.timeline.keys.clear(); });
    ASSERT_TRUE(edit);
    const Result<bool> keyed = makeEditsAt(scene, std::vector{*edit}, {.shown = 4, .key = 4});
    ASSERT_TRUE(keyed) << describe(keyed.error());
    EXPECT_FALSE(*keyed);
    EXPECT_EQ(scene.timeline, Timeline{});
    EXPECT_EQ(scene.material.shininess, 4);
}

TEST(EditsAtATime, AreAllMadeOrNone) {
    Scene scene = moving();
    const std::vector<Edit> edits{edit::Set{"material.shininess", "7"}, edit::Remove{"models", 9}};
    EXPECT_FALSE(makeEditsAt(scene, edits, {.shown = 4, .key = 4}));
    EXPECT_EQ(scene, moving());
    const std::vector<Edit> late{edit::Set{"material.shininess", "7"}};
    EXPECT_FALSE(makeEditsAt(scene, late, {.shown = 4, .key = maxKeyTime * 2})) << "no key can be there";
    EXPECT_EQ(scene, moving());
}

/// What a scene says of its objects, without their indices: each pass with the names of its models and the
/// bias of its texture, and each texture's bias with its key frames.
std::vector<std::string> relations(const Scene& scene) {
    std::vector<std::string> said;
    for (const Pass& pass : scene.passes) {
        for (const int model : pass.models)
            said.push_back(
                fmt::format("{} draws {}", pass.name, scene.models.at(static_cast<std::size_t>(model)).name));
        said.push_back(
            fmt::format("{} shows {}", pass.name,
                        scene.textures.at(static_cast<std::size_t>(pass.units[0].texture)).lodBias));
    }
    for (const KeyFrame& key : scene.timeline.keys) {
        const std::string index = key.path.substr(key.path.find('[') + 1, 1);
        said.push_back(fmt::format("{} moves", scene.textures.at(std::stoul(index)).lodBias));
    }
    std::ranges::sort(said);
    return said;
}

TEST(Edits, NameTheSameElementsAfterAnyMoves) {
    std::mt19937 random(7);
    Scene scene = threeOfEach();
    const std::vector<std::string> before = relations(scene);
    for (int i = 0; i < 500; ++i) {
        constexpr std::array lists{"models", "textures", "passes"};
        const Edit move = edit::Move{lists[random() % 3], random() % 3, random() % 3};
        ASSERT_TRUE(makeEdits(scene, std::vector{move}));
        ASSERT_EQ(relations(scene), before) << i;
    }
}

// The scene can always be written and read, after edits that were made and after edits that were refused.
TEST(Edits, LeaveAValidSceneInAnyOrder) {
    std::mt19937 random(11);
    Scene scene = threeOfEach();
    for (int i = 0; i < 400; ++i) {
        constexpr std::array lists{"models",
                                   "textures",
                                   "passes",
                                   "passes[0].units[0].matrix",
                                   "textures[0].preparation",
                                   "textures[0].levels",
                                   "timeline.keys",
                                   "passes[0].units"};
        const std::string list = lists[random() % lists.size()];
        const std::size_t index = random() % 5;
        const Edit edits[] = {edit::Insert{list, index}, edit::Insert{list, index, random() % 4},
                              edit::Remove{list, index}, edit::Move{list, index, random() % 4}};
        const Edit& edit = edits[random() % 4];
        const Scene before = scene;
        if (list == "timeline.keys" && edit.index() == 1)
            continue; // an empty key names no parameter
        if (!makeEdits(scene, std::vector{edit})) {
            ASSERT_EQ(scene, before);
        }
        const Result<Scene> read = parseScene(writeScene(scene));
        ASSERT_TRUE(read) << i << ": " << describe(read.error());
        ASSERT_EQ(*read, scene);
    }
}

} // namespace
} // namespace texplorer::edit_test
