// Files of released versions, tests/fixtures/released/VERSION: they open, with the values that were written,
// and are drawn as they were. The pictures and most lists of values come from the program of that version.
// They prove only that nothing has changed since, and that is their purpose: other tests prove what is right.

#include "texplorer/files/file_io.h"
#include "texplorer/golden/golden.h"
#include "texplorer/lesson/lesson_files.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/param_listing.h"
#include "texplorer/scene/storage/scene_file.h"
#include "texplorer/scene/storage/scene_link.h"
#include "texplorer/scene/storage/unsaved_scene.h"
#include "texplorer/suite/case_scene.h"
#include "texplorer/suite/suite_folder.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace texplorer::released_files_test {
namespace {

namespace fs = std::filesystem;

const fs::path releases = fs::path(TEXPLORER_SOURCE_DIR) / "tests/fixtures/released";
constexpr double pictureTime = 0.75; ///< of the scenes

/// Empty if there is no such folder.
std::vector<fs::path> entriesOf(const fs::path& folder) {
    std::vector<fs::path> paths;
    std::error_code ignored;
    for (const fs::directory_entry& each : fs::directory_iterator(folder, ignored))
        paths.push_back(each.path());
    std::ranges::sort(paths);
    return paths;
}

std::string textIn(const fs::path& file) {
    const Result<std::string> text = readText(file);
    EXPECT_TRUE(text) << describe(text.error());
    return text.value_or("");
}

struct ListedValue {
    std::string path;
    std::string text;
};

/// A file of values: "[view]", then "azimuth = 24" and so on; lists have lengths, "models = 2 elements".
std::vector<ListedValue> valuesIn(const fs::path& file) {
    constexpr std::string_view between = " =";
    std::vector<ListedValue> values;
    std::string owner;
    std::istringstream lines(textIn(file));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('[')) {
            owner = line.size() > 2 ? line.substr(1, line.size() - 2) + "." : "";
            continue;
        }
        const std::size_t end = line.find(between);
        if (end == std::string::npos) {
            ADD_FAILURE() << file << ": " << line;
            continue;
        }
        const std::size_t start = std::min(end + between.size() + 1, line.size());
        values.push_back({owner + line.substr(0, end), line.substr(start)});
    }
    return values;
}

/// "textures[].levels[].file" of "textures[3].levels[0].file".
std::string withoutNumbers(const std::string& path) {
    static const std::regex number(R"(\[\d+\])");
    return std::regex_replace(path, number, "[]");
}

std::map<std::string, std::string> initialTexts(const fs::path& release) {
    std::map<std::string, std::string> texts;
    for (const ListedValue& each : valuesIn(release / "initial.values"))
        texts[each.path] = each.text;
    return texts;
}

/// Whether the text is that value; the same number may be written in different ways.
testing::AssertionResult isValue(const ParamRow& row, const Value& value, const std::string& text) {
    const Result<Value> expected = parseValue(row, text);
    if (!expected)
        return testing::AssertionFailure() << describe(expected.error());
    return testing::AssertionResult(value == *expected)
           << "expected " << text << ", found " << formatValue(row, value);
}

/// A scene that a release has kept.
struct OldScene {
    fs::path file;
    fs::path picture; ///< the same file if it contains its scene
    fs::path values;  ///< may not exist
};

std::vector<OldScene> scenesOf(const fs::path& release) {
    std::vector<OldScene> scenes;
    for (const fs::path& file : entriesOf(release / "scenes")) {
        const std::string extension = file.extension().string();
        if (extension != ".json" && extension != ".link" && extension != ".scene" &&
            !isPictureWithScene(file))
            continue;
        const std::string name = file.filename().string();
        const fs::path start = file.parent_path() / name.substr(0, name.find('.'));
        scenes.push_back({file, start.string() + ".png", start.string() + ".values"});
    }
    return scenes;
}

Result<Scene> opened(const fs::path& file) {
    if (file.extension() == ".link")
        return readText(file).and_then([](const std::string& text) { return parseSceneLink(text); });
    if (file.extension() == ".scene")
        return readText(file)
            .and_then([](const std::string& text) { return parseUnsaved(text); })
            .map([](const UnsavedScene& draft) { return draft.scene; });
    return readSceneFile(file).and_then([](const SceneContent& read) { return parseScene(read.text); });
}

/// Whether a scene is drawn as in the picture, which must exist. The picture is never updated.
testing::AssertionResult isDrawnAs(const fs::path& picture, const Scene& scene, const ImageSource& images,
                                   double time) {
    const Result<Frame> frame =
        reference::drawReference({.scene = scene, .images = images, .time = time, .width = 48, .height = 32});
    if (!frame)
        return testing::AssertionFailure() << describe(frame.error());
    if (!frame->problems.empty())
        return testing::AssertionFailure() << frame->problems.front();
    const fs::path failures = "failures" / picture.parent_path().lexically_relative(releases);
    const Result<GoldenCheck> check =
        checkGolden(frame->image, picture,
                    {.criterion = {.tolerance = 0, .compared = Compared::Rgb}, .failures = failures});
    if (!check)
        return testing::AssertionFailure() << describe(check.error());
    const std::string_view message = check->message; // whose last line says how to update a golden
    return testing::AssertionResult(check->alike) << message.substr(0, message.rfind('\n'));
}

TEST(ReleasedFiles, AreThereForThisVersion) {
    EXPECT_TRUE(fs::exists(releases / TEXPLORER_VERSION / "initial.values")) << "see docs/develop/release.md";
}

TEST(ReleasedFiles, OpenWithTheirValues) {
    for (const fs::path& release : entriesOf(releases)) {
        const std::map<std::string, std::string> initial = initialTexts(release);
        for (const OldScene& old : scenesOf(release)) {
            SCOPED_TRACE(old.file);
            Result<Scene> scene = opened(old.file);
            ASSERT_TRUE(scene) << describe(scene.error());
            if (!fs::exists(old.values))
                continue;
            std::set<std::string> listed;
            for (const ListedValue& each : valuesIn(old.values)) {
                listed.insert(each.path);
                if (each.text.ends_with(" elements")) {
                    const Result<ListAt> list = listAt(*scene, each.path);
                    ASSERT_TRUE(list) << describe(list.error());
                    EXPECT_EQ(fmt::format("{} elements", list->size()), each.text) << each.path;
                    continue;
                }
                const Result<ParamAt> param = paramAt(*scene, each.path);
                ASSERT_TRUE(param) << describe(param.error());
                EXPECT_TRUE(isValue(*param->row, param->value, each.text)) << each.path;
            }
            forEachParam(*scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
                const auto found = initial.find(withoutNumbers(path));
                if (listed.contains(path) || found == initial.end()) // a parameter of a later version
                    return;
                EXPECT_TRUE(isValue(row, value, found->second)) << path;
            });
        }
    }
}

TEST(ReleasedFiles, AreDrawnAsTheyWere) {
    int count = 0;
    for (const fs::path& release : entriesOf(releases)) {
        for (const OldScene& old : scenesOf(release)) {
            SCOPED_TRACE(old.file);
            const Result<Scene> scene = opened(old.file);
            ASSERT_TRUE(scene) << describe(scene.error());
            ImageSource images(old.file.parent_path());
            const Result<void> loaded = images.load(*scene);
            ASSERT_TRUE(loaded) << describe(loaded.error());
            EXPECT_TRUE(isDrawnAs(old.picture, *scene, images, pictureTime));
            ++count;
        }
    }
    EXPECT_GE(count, 9);
}

// What a file omits has this value.
TEST(ReleasedFiles, HaveTheSameInitialValues) {
    std::map<std::string, std::pair<const ParamRow*, Value>> now;
    forEachNewParam([&](const std::string& path, const ParamRow& row, const Value& value) {
        now[path] = {&row, value};
    });
    for (const fs::path& release : entriesOf(releases)) {
        for (const auto& [path, text] : initialTexts(release)) {
            const auto found = now.find(path);
            ASSERT_NE(found, now.end()) << path;
            EXPECT_TRUE(isValue(*found->second.first, found->second.second, text)) << path;
        }
    }
}

TEST(ReleasedFiles, UseEveryParameterOfTheirVersion) {
    std::map<std::string, std::string> initial; // of all versions
    std::set<std::string> used;
    for (const fs::path& release : entriesOf(releases))
        initial.merge(initialTexts(release));
    for (const fs::path& release : entriesOf(releases)) {
        for (const OldScene& old : scenesOf(release)) {
            if (!fs::exists(old.values))
                continue;
            for (const ListedValue& each : valuesIn(old.values)) {
                const auto found = initial.find(withoutNumbers(each.path));
                if (found != initial.end() && found->second != each.text)
                    used.insert(found->first);
            }
        }
    }
    for (const auto& [path, text] : initial)
        EXPECT_TRUE(used.contains(path)) << path;
}

TEST(ReleasedFiles, IncludeADraftOfTheWindow) {
    const Result<UnsavedScene> draft = parseUnsaved(textIn(releases / "0.1.0/scenes/draft.scene"));
    ASSERT_TRUE(draft) << describe(draft.error());
    EXPECT_EQ(draft->file, "/home/ann/lab/half 50%.texplorer.json");
    EXPECT_EQ(draft->folder, "/home/ann/lab");
    EXPECT_EQ(draft->fileHash, "e11b7589c77565c8876858478dcd034d");
}

TEST(ReleasedFiles, AreKnownByTheirKind) {
    const fs::path scenes = releases / "0.1.0/scenes";
    EXPECT_TRUE(isSceneLink(textIn(scenes / "mesh.link")));
    EXPECT_TRUE(isPictureWithScene(scenes / "units.png"));
    EXPECT_FALSE(isPictureWithScene(scenes / "light.png"));
}

// Suites.

TEST(ReleasedFiles, HaveSuitesWithTheSameCases) {
    for (const fs::path& release : entriesOf(releases)) {
        SCOPED_TRACE(release);
        const Result<std::vector<suite::Suite>> suites = suite::suitesAt(release);
        ASSERT_TRUE(suites) << describe(suites.error());
        const Result<suite::Plan> plan = suite::planOf(*suites);
        ASSERT_TRUE(plan) << describe(plan.error());
        std::istringstream names(textIn(release / "cases.list"));
        for (std::string name; std::getline(names, name);) { // "*" may mean more of them now
            const auto found = std::ranges::find(plan->cases, name, &suite::Case::name);
            ASSERT_NE(found, plan->cases.end()) << name;
            ASSERT_FALSE(found->problem) << name << ": " << describe(*found->problem);
            Result<suite::CaseScene> scene = suite::openScene(*plan, *found);
            ASSERT_TRUE(scene) << name << ": " << describe(scene.error());
            const Result<void> loaded = scene->load();
            EXPECT_TRUE(loaded) << name << ": " << describe(loaded.error());
        }
    }
}

TEST(ReleasedFiles, HaveASuiteWithEveryKey) {
    using namespace suite;
    Settings defaults{
        .sizes = {{48, 32}}, .times = {0.75}, .renderers = {RendererKind::Reference}, .seconds = 30};
    defaults.criterion = {
        .metric = Metric::Absolute, .tolerance = 2, .share = 0.005, .compared = Compared::Rgb};

    Entry files{.name = "files", .settings = defaults};
    files.scenes = {SceneFile{"scenes/light.texplorer.json"}, SceneFile{"scenes/textures.texplorer.json"}};
    files.settings.golden = GoldenFiles{{{"*", {"scenes/light.png"}}}};
    files.settings.criterion.tolerance = 255;

    Entry axes{.scenes = {SceneExample{"cube"}}, .settings = defaults};
    axes.axes = {"textures[0].minFilter=GL_NEAREST,GL_LINEAR", "view.distance=3..9/2"};
    axes.settings.sizes = {{64, 64}, {32, 24}};
    axes.settings.times = {0, 1.5};

    Entry answer{.scenes = {SceneLesson{"lesson", 2, 2, false}}, .settings = defaults};
    answer.settings.renderers = {RendererKind::Fixed, RendererKind::Shader};
    answer.settings.golden = GoldenReference{};

    Entry reached{.scenes = {SceneLesson{"lesson", 3, 0, true}}, .settings = defaults};
    reached.settings.renderers = {RendererKind::Shader};
    reached.settings.golden = GoldenReference{"none"};
    reached.settings.criterion.metric = Metric::Ssim;
    reached.settings.criterion.tolerance = 0.125;
    reached.settings.criterion.share = 0.25;

    Entry within{.name = "inline", .settings = defaults};
    within.edits = {edit::ApplyPreset{"alpha-test"}, edit::Set{"view.azimuth", "-30"}};
    within.settings.golden =
        GoldenFiles{{{"llvmpipe*", {"golden/{case}@{driver}.png", "golden/{picture}.png"}},
                     {"*", {"golden/{case}.png"}}}};
    within.settings.criterion.metric = Metric::Flip;
    within.settings.criterion.tolerance = 0.25;
    within.settings.criterion.pixelsPerDegree = 32;
    within.settings.criterion.compared = Compared::Rgba;
    within.settings.mask = "scenes/tests.png";

    Entry start{.edits = {edit::Set{"light.twoSide", "true"}}, .settings = defaults};
    start.axes = {"passes[0].units[0].envMode=*"};
    start.settings.seconds = 2.5;

    const Result<Suite> read = readSuite(releases / "0.1.0/pictures.suite.json");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->name, "pictures");
    EXPECT_EQ(read->about, "Every key of a suite.");
    ASSERT_EQ(read->entries.size(), 6U);
    const auto* json = std::get_if<SceneInline>(&read->entries[4].scenes.at(0));
    ASSERT_NE(json, nullptr);
    EXPECT_EQ(parseScene(json->json).value().textures.at(0).pattern, Pattern::Brick);
    within.scenes = read->entries[4].scenes;
    EXPECT_EQ(read->entries, (std::vector{files, axes, answer, reached, within, start}));
}

// Lessons.

TEST(ReleasedFiles, HaveLessonsThatAreDrawnAsTheyWere) {
    using namespace lesson;
    int count = 0;
    const auto compare = [&count](const fs::path& picture, const Result<LessonScene>& scene) {
        ASSERT_TRUE(scene) << picture << ": " << describe(scene.error());
        if (!fs::exists(picture)) // of an example, which may change
            return;
        ++count;
        EXPECT_TRUE(isDrawnAs(picture, scene->scene, scene->images, 0)) << picture;
    };
    for (const fs::path& release : entriesOf(releases)) {
        const fs::path path = release / "lesson";
        const LessonFolder folder = LessonFolder::onDisk(path);
        const Result<Lesson> lesson = readLesson(folder);
        ASSERT_TRUE(lesson) << describe(lesson.error());
        for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
            const Result<LessonScene> start = startOf(folder, *lesson, i);
            compare(path / fmt::format("step-{}.png", i + 1), start);
            if (const auto* match = std::get_if<Match>(&lesson->steps[i].task))
                compare(path / fmt::format("step-{}-reached.png", i + 1), withEdits(*start, match->edits));
            const auto* predict = std::get_if<Predict>(&lesson->steps[i].task);
            for (std::size_t j = 0; predict && j < predict->answers.size(); ++j)
                compare(path / fmt::format("step-{}-answer-{}.png", i + 1, j + 1),
                        withEdits(*start, predict->answers[j].edits));
        }
    }
    EXPECT_GE(count, 3);
}

TEST(ReleasedFiles, HaveALessonWithEveryKey) {
    using namespace lesson;
    const auto set = [](const char* path, const char* value) -> std::vector<Edit> {
        return {edit::Set{path, value}};
    };
    Lesson expected{.title = "Every kind of step",
                    .source = "OpenGL 2.1, 3.8.7",
                    .about = "You have seen each key of a lesson.",
                    .steps = std::vector<Step>(5)};
    Step& tried = expected.steps[0];
    tried = {.title = "To try", .text = "The marked pixel is {color}.", .scene = "board.json"};
    tried.edits = {edit::Set{"textures[0].magFilter", "GL_NEAREST"}, edit::ApplyPreset{"alpha-test"}};
    tried.look = {.param = "textures[0].wrapS",
                  .tab = "explain",
                  .shown = "lambda",
                  .renderer = "fixed,reference",
                  .probeX = 310,
                  .probeY = 640};
    tried.task = Try{"Choose another wrap mode."};

    Step& pictures = expected.steps[1];
    pictures = {.title = "To answer by a picture", .text = "The edge continues."};
    pictures.edits = set("textures[0].wrapS", "GL_CLAMP_TO_EDGE");
    pictures.look = {
        .figure = "edge", .shown = "picture", .renderer = "shader", .probeX = 310, .probeY = 640};
    pictures.task = Predict{"What does GL_REPEAT show?",
                            {{"The image again.", set("textures[0].wrapS", "GL_REPEAT")},
                             {"Its edge.", set("textures[0].wrapS", "GL_CLAMP_TO_EDGE")},
                             {"The image reversed.", set("textures[0].wrapS", "GL_MIRRORED_REPEAT")}},
                            0,
                            "Only the fraction counts: {s}."};

    Step& reached = expected.steps[2];
    reached = {.title = "To reach", .text = "Two units.", .scene = "cube"};
    reached.edits = set("passes[0].units[1].enabled", "true");
    reached.task =
        Match{"Turn the camera.", {edit::Set{"view.azimuth", "-40"}, edit::Set{"view.elevation", "45"}}};
    reached.fallback = Fallback{"One unit is enough.", set("passes[0].units[1].enabled", "false")};

    Step& words = expected.steps[3];
    words = {.title = "To answer in words", .text = "There is nothing to draw."};
    words.task = Predict{"How many units has this pass?",
                         {{"One", {}}, {"Two", {}}, {"Three", {}}, {"Four", {}}},
                         3,
                         "Always four."};

    expected.steps[4] = {.title = "Only a text", .text = "The end."};
    expected.keys = {{"F", "Filter",
                      Cycle{{{"blocks", set("textures[0].magFilter", "GL_NEAREST")},
                             {"smooth", set("textures[0].magFilter", "GL_LINEAR")}}}},
                     {"Page Up", "Farther", Addition{"view.distance", 0, 0.25F}},
                     {"7", "Up", Addition{"view.target", 1, -0.5F}}};

    const Result<Lesson> read = readLesson(LessonFolder::onDisk(releases / "0.1.0/lesson"));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, expected);
}

} // namespace
} // namespace texplorer::released_files_test
