// A lesson in a session: the picture of a step, the effect of an answer, the saved state.

#include "app/ui/files/answers.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/inspected_file.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/lesson_list.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/services/settings_file.h"
#include "app/ui/services/settings_json.h"
#include "app/ui/state/details_tabs.h"
#include "app/ui/state/inspected_file.h"
#include "app/ui/state/lesson_records.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cctype>

namespace texplorer::ui::lesson_run_test {
namespace {

using namespace test;
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view small = R"({
    "lesson": 1, "title": "Small", "about": "A", "steps": [
    {"title": "First", "text": "T", "scene": "cube", "edits": ["material.shininess=7"],
     "look": {"param": "textures[0].wrapS", "tab": "memory", "shown": "lambda", "renderer": "fixed,reference",
              "probe": [500, 250]}, "try": "Turn it."},
    {"title": "Second", "text": "T", "look": {"probe": [500, 500]},
     "predict": {"question": "Q", "right": 1, "reason": "It is {fragment}.",
                 "answers": [{"text": "one", "edits": ["material.color=1,0,0,1"]},
                             {"text": "two", "edits": ["material.color=0,1,0,1"]}]}},
    {"title": "Third", "text": "T", "scene": "checker",
     "match": {"task": "M", "edits": ["view.background=1,1,1,1"]}}]})";

Settings readBack(const Settings& settings) {
    std::vector<std::string> leftOut;
    return parseSettings(writeSettings(settings), leftOut).value();
}

class LessonRuns : public Workbench {
protected:
    LessonRuns() {
        fs::create_directory(folder);
        write(small);
    }
    void write(std::string_view text) const {
        ASSERT_TRUE(writeFileAtomically(folder / "lesson.json", viewBytes(text)));
    }
    void openSmall(std::optional<std::size_t> step = {}) {
        const Result<void> opened = openLessonNamed(*session, folder.string(), step);
        ASSERT_TRUE(opened) << describe(opened.error());
        frames(3);
    }
    [[nodiscard]] LessonRun& run() { return *session->lesson; }
    [[nodiscard]] std::vector<StepRecord>& records() { return session->settings.lessons[run().key]; }
    void edit(glm::vec4 background) {
        scene().view.background = background;
        recordEdit(*session, "Background");
        sealEdit(*session);
        frames(3);
    }

    texplorer::test::TempDir parent;
    fs::path folder = parent / "small";
};

TEST_F(LessonRuns, BeginWithTheStepsSceneAndLook) {
    openSmall();
    EXPECT_EQ(scene().material.shininess, 7);
    EXPECT_FALSE(session->document.history.canUndo());
    EXPECT_TRUE(session->document.file.empty());
    EXPECT_EQ(session->look.shownParam, "textures[0].wrapS");
    EXPECT_EQ(session->view.shown, reference::Shown::Lambda);
    EXPECT_THAT(shownRenderers(session->view), ElementsAre(RendererKind::Fixed, RendererKind::Reference));
    ASSERT_TRUE(session->look.explaining.pixel);
    EXPECT_EQ(session->look.explaining.pixel->x, layout.picture.width / 2);
    EXPECT_EQ(session->look.explaining.pixel->y, layout.picture.height - 1 - layout.picture.height / 4);
    EXPECT_TRUE(isOpen(session->settings.workspace, Tab::Lesson));
    EXPECT_THAT(records(), ElementsAre(StepRecord{true, 0, -1}, StepRecord{}, StepRecord{}));
}

TEST_F(LessonRuns, HaveTheNumbersAndTheMarkOfThePictureThatIsShown) {
    write(R"({"lesson": 1, "title": "Small", "about": "A", "steps": [
        {"title": "S", "text": "It is {up}.", "scene": "checker", "look": {"probe": [490, 480]}}]})");
    ASSERT_TRUE(openLessonNamed(*session, folder.string()));
    EXPECT_EQ(run().stepText("It is {up}."), "It is ….") << "it takes its time";
    frames(3);
    const auto expectThose = [&] {
        const lesson::PictureSize size{layout.picture.width, layout.picture.height};
        EXPECT_EQ(session->look.explaining.pixel, lesson::pixelOf(490, 480, size));
        const std::string text = run().stepText("It is {up}.");
        EXPECT_EQ(text, numbersOf(run().start, run().lesson.steps[0].look, size)->in("It is {up}."));
        return text;
    };
    const std::string before = expectThose();
    session->settings.workspace.maximised = Maximised::View;
    frames(3);
    EXPECT_NE(expectThose(), before);
    session->look.explaining.pixel = {7, 8};
    frames(3);
    EXPECT_EQ(session->look.explaining.pixel, (reference::PixelPlace{7, 8})) << "the student's own";
}

TEST_F(LessonRuns, FallBackWhereTheDriverHasOneUnit) {
    ASSERT_TRUE(openLessonNamed(*session, "bumps", 0));
    EXPECT_EQ(run().start.fallback, "");
    followLesson(*session, {{320, 240}, 1});
    EXPECT_NE(run().start.fallback, "");
    EXPECT_EQ(lesson::unitsUsed(scene()), 1);
    const auto drawsTheCube = [](const Pass& pass) {
        return pass.enabled && std::ranges::find(pass.models, 0) != pass.models.end();
    };
    EXPECT_EQ(std::ranges::count_if(scene().passes, drawsTheCube), 3) << "NeHe 22: units > 1 ? two : one";
    goToLessonStep(*session, 1);
    EXPECT_EQ(lesson::unitsUsed(scene()), 1);
    goToLessonStep(*session, 7);
    EXPECT_EQ(run().start.fallback, "") << "it has one unit anyway";
}

TEST_F(LessonRuns, CountAnswersUntilTheRightOne) {
    openSmall(1);
    ASSERT_TRUE(run().pictures);
    EXPECT_EQ(run().pictures->size(), 2U);
    const Scene start = scene();
    answerQuestion(*session, 0);
    EXPECT_EQ(records()[1], (StepRecord{false, 1, 0}));
    EXPECT_EQ(run().reason(), "");
    EXPECT_EQ(scene(), start) << "a wrong answer shows nothing";
    answerQuestion(*session, 7); // there is none
    answerQuestion(*session, 1);
    takeRequests(*session);
    EXPECT_EQ(records()[1], (StepRecord{true, 2, 1}));
    EXPECT_EQ(run().reason(), "It is (0, 1, 0, 1).");
    EXPECT_EQ(scene().material.color, glm::vec4(0, 1, 0, 1)) << "what was right is shown";
    EXPECT_EQ(session->document.history.undoName(), "Answer");
    answerQuestion(*session, 0);
    EXPECT_EQ(records()[1], (StepRecord{true, 2, 1})) << "what is done stays done";
}

TEST_F(LessonRuns, MatchIsDoneByThePictureAlone) {
    openSmall(2);
    ASSERT_TRUE(run().grade);
    EXPECT_FALSE(run().grade->passed);
    EXPECT_FALSE(run().hintAsked) << "it was not requested";
    EXPECT_FALSE(isStepDone(session->settings, run().key, 2));
    edit({0.5F, 0.5F, 0.5F, 1});
    EXPECT_FALSE(run().grade->passed);
    run().wantsHint = true;
    frames(2);
    ASSERT_TRUE(run().hint && run().hint->hint);
    EXPECT_EQ(run().hint->hint->path, "view.background");
    EXPECT_EQ(run().hint->scene.view.background.r, 0.5F);
    edit({1, 1, 1, 1});
    EXPECT_TRUE(run().grade->passed);
    EXPECT_TRUE(isStepDone(session->settings, run().key, 2));
    edit({0, 0, 0, 1});
    EXPECT_FALSE(run().grade->passed);
    EXPECT_TRUE(isStepDone(session->settings, run().key, 2)) << "what is done stays done";
}

TEST_F(LessonRuns, MatchMayBeLookedAtFromAnywhere) {
    openSmall(2);
    EXPECT_EQ(scene().view, run().start.scene.view) << "the camera is the step's, not one that fits";
    scene().view.azimuth += 40;
    scene().view.distance *= 2;
    frames(2);
    run().wantsHint = true;
    frames(2);
    EXPECT_EQ(run().hint->hint->path, "view.background");
    edit({1, 1, 1, 1});
    EXPECT_TRUE(run().grade->passed);
}

TEST_F(LessonRuns, GoToStepsAndBack) {
    openSmall();
    goToLessonStep(*session, 2);
    EXPECT_EQ(run().step, 2U);
    EXPECT_EQ(scene(), run().start.scene);
    goToLessonStep(*session, 3);
    EXPECT_EQ(run().step, 2U) << "there is none";
    edit({1, 0, 0, 1});
    goToLessonStep(*session, 2);
    EXPECT_EQ(scene(), run().start.scene) << "from its start";
    goToLessonStep(*session, 0);
    EXPECT_EQ(scene().material.shininess, 7);
}

TEST_F(LessonRuns, GoOnWhereOneWas) {
    openSmall();
    goToLessonStep(*session, 1);
    answerQuestion(*session, 1);
    session->settings = readBack(session->settings);
    closeLesson(*session);
    EXPECT_FALSE(session->lesson);
    EXPECT_FALSE(isOpen(session->settings.workspace, Tab::Lesson));
    openSmall();
    EXPECT_EQ(run().step, 2U) << "the first that isn't done";
    EXPECT_EQ(progressOf(session->settings, run().key, 3).done, 2U);
    records().assign(3, {true, 1, 0});
    openSmall();
    EXPECT_EQ(run().step, 0U) << "all are: from the beginning";
    records().assign(100, {true, 1, 0}); // of a lesson that was longer
    openSmall();
    EXPECT_EQ(run().step, 0U);
}

TEST_F(LessonRuns, BrokenSayWhereAndChangeNothing) {
    openSmall(1);
    const Scene before = scene();
    for (const std::string_view text : {R"({"lesson": 1)", R"({"lesson": 1, "title": "L"})", "",
                                        R"({"lesson": 1, "title": "L", "about": "A",
                                            "steps": [{"title": "S", "text": "T", "scene": "../x"}]})"}) {
        write(text);
        askLesson(*session, folder.string());
        frames(2);
        EXPECT_THAT(
            session->look.notice.text,
            HasSubstr(text.find("../x") == std::string_view::npos ? "lesson.json" : "/steps/0/scene"));
        ASSERT_TRUE(session->lesson);
        EXPECT_EQ(run().lesson.title, "Small");
        EXPECT_EQ(run().step, 1U);
        EXPECT_EQ(scene(), before);
    }
    const Result<void> none = openLessonNamed(*session, "nothing");
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().message, HasSubstr("expected one of first-texture, "));
    EXPECT_EQ(run().lesson.title, "Small");
}

TEST_F(LessonRuns, AreKeptAsOneFile) {
    ASSERT_TRUE(openLessonNamed(*session, "wrap", 1));
    answerQuestion(*session, 1);
    answerQuestion(*session, 0);
    const nlohmann::json answers = nlohmann::json::parse(answersText(session->settings))["answers"];
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers[0]["lesson"], "wrap");
    const nlohmann::json& step = answers[0]["steps"][1];
    EXPECT_EQ(step["step"], 2);
    EXPECT_EQ(step["title"], "Mirrored");
    EXPECT_EQ(step["tries"], 2);
    EXPECT_EQ(step["done"], true);
    EXPECT_EQ(answers[0]["steps"][2]["done"], false);
}

TEST_F(LessonRuns, OfTheProgramHaveTheirFilesInTheTabFileAndBesideASavedScene) {
    ASSERT_TRUE(openLessonNamed(*session, "dds", 0));
    EXPECT_FALSE(run().awaitsImages) << "they are in the program";
    frames(2);
    followFile(*session);
    const InspectedFile& inspected = session->look.fileView;
    ASSERT_TRUE(inspected.content) << inspected.problem;
    EXPECT_EQ(inspected.shown, "dxt1.dds");
    EXPECT_EQ(inspected.content->fileBytes, 11064U);
    fs::create_directory(parent / "other");
    ASSERT_TRUE(writeFileAtomically(parent / "other" / "dxt1.dds", viewBytes("mine")));
    EXPECT_FALSE(saveScene(*session, parent / "other" / "scene.json")) << "that is another file";
    EXPECT_FALSE(fs::exists(parent / "other" / "scene.json"));
    EXPECT_EQ(fs::file_size(parent / "other" / "dxt1.dds"), 4U);
    ASSERT_TRUE(saveScene(*session, parent / "scene.json"));
    EXPECT_EQ(fs::file_size(parent / "dxt1.dds"), 11064U);
    EXPECT_EQ(texture().file, "dxt1.dds");
    ASSERT_TRUE(openScene(*session, parent / "scene.json"));
    frames(2);
    EXPECT_TRUE(session->document.images.holds("dxt1.dds"));
}

/// The window doesn't wait for images on the disk.
TEST_F(LessonRuns, ReceiveTheirFoldersImagesLater) {
    Scene pictured = defaultScene();
    pictured.textures[0].source = SourceKind::File;
    pictured.textures[0].file = "red.bmp";
    ASSERT_TRUE(writeFileAtomically(folder / "s.json", viewBytes(writeScene(pictured))));
    ASSERT_TRUE(writeFileAtomically(folder / "red.bmp", viewBytes(onePixelBmp({'\0', '\0', '\xff'}))));
    write(R"({"lesson": 1, "title": "Small", "about": "A", "steps": [
        {"title": "S", "text": "T", "scene": "s.json",
         "match": {"task": "M", "edits": ["view.background=1,1,1,1"]}},
        {"title": "S", "text": "T", "edits": ["material.shininess=3"]}]})");
    ASSERT_TRUE(openLessonNamed(*session, folder.string()));
    EXPECT_TRUE(run().awaitsImages);
    EXPECT_FALSE(run().start.images.holds("red.bmp"));
    frames(2);
    EXPECT_FALSE(run().awaitsImages);
    EXPECT_TRUE(session->document.images.holds("red.bmp"));
    ASSERT_TRUE(run().pictures);
    EXPECT_TRUE(run().pictures->front());
    EXPECT_TRUE(run().grade);
    goToLessonStep(*session, 1);
    EXPECT_FALSE(run().awaitsImages) << "the step before has read it";
    fs::remove(folder / "red.bmp");
    closeLesson(*session);
    newScene(*session);
    ASSERT_TRUE(openLessonNamed(*session, folder.string(), 0));
    frames(2);
    EXPECT_THAT(session->look.notice.text, HasSubstr("red.bmp"));
    EXPECT_FALSE(run().awaitsImages) << "one goes on without";
    EXPECT_TRUE(run().grade);
}

/// Progress in a built-in lesson does not count for a teacher's lesson of the same name.
TEST_F(LessonRuns, KeepFoldersApartByWhereTheyAre) {
    fs::create_directories(parent / "wrap");
    ASSERT_TRUE(writeFileAtomically(parent / "wrap" / "lesson.json", viewBytes(small)));
    ASSERT_TRUE(openLessonNamed(*session, "wrap", 1));
    answerQuestion(*session, 0);
    ASSERT_TRUE(openLessonNamed(*session, (parent / "wrap").string()));
    EXPECT_EQ(run().step, 0U);
    EXPECT_FALSE(isStepDone(session->settings, run().key, 1));
    EXPECT_TRUE(isStepDone(session->settings, "wrap", 1));
    fs::create_directory_symlink("wrap", parent / "linked");
    EXPECT_EQ(progressKey(lesson::LessonFolder::onDisk(parent / "linked")), run().key);
    EXPECT_EQ(progressKey(lesson::LessonFolder::onDisk(parent / "wrap" / "")), run().key);
    const nlohmann::json answers = nlohmann::json::parse(answersText(session->settings))["answers"];
    ASSERT_EQ(answers.size(), 2U);
    for (const nlohmann::json& each : answers)
        EXPECT_EQ(each["lesson"], "wrap");
}

TEST_F(LessonRuns, TakeOverWhatWasKeptByAFoldersNameAlone) {
    session->settings.lessons["small"] = {{true, 0, -1}, {true, 2, 1}, {}};
    openSmall();
    EXPECT_EQ(run().step, 2U);
    EXPECT_FALSE(session->settings.lessons.contains("small"));
    EXPECT_EQ(session->settings.lessons.size(), 1U);
}

TEST_F(LessonRuns, AreKeptOfSoManyLessonsAsSettingsHold) {
    for (std::size_t i = 0; i < maxLessonsKept; ++i)
        session->settings.lessons[fmt::format("/gone/{}", i)] = {{true, 0, -1}};
    ASSERT_TRUE(openLessonNamed(*session, "wrap", 0));
    openSmall();
    EXPECT_EQ(session->settings.lessons.size(), maxLessonsKept);
    EXPECT_TRUE(session->settings.lessons.contains("wrap"));
    EXPECT_TRUE(session->settings.lessons.contains(run().key));
    EXPECT_EQ(readBack(session->settings), session->settings);
}

TEST(LessonTabs, AreThoseOfTheWindow) {
    std::vector<std::string_view> names;
    for (const TabRow& row : tabRows) {
        if (row.tab != Tab::Lesson && row.tab != Tab::Figures) // Look::figure sets it
            names.push_back(row.name);
    }
    EXPECT_THAT(names, testing::UnorderedElementsAreArray(lesson::lookTabs));
}

/// All texts of a lesson are translated, in every language.
class LessonTexts : public testing::TestWithParam<std::string> {};

TEST_P(LessonTexts, AreTranslated) {
    const lesson::LessonFolder folder = lesson::LessonFolder::builtIn(GetParam()).value();
    const lesson::Lesson lesson = readLesson(folder).value();
    for (const Language language : {Language::Chinese, Language::Russian}) {
        const std::shared_ptr<const Catalogue> catalogue = catalogueOfLesson(folder, language);
        ASSERT_TRUE(catalogue) << rowOf(language).name;
        for (const std::string& text : textsOf(lesson)) {
            if (std::ranges::none_of(text, [](unsigned char each) { return std::isalpha(each) != 0; }))
                continue; // "(12, 3)"
            EXPECT_TRUE(catalogue->find(text)) << rowOf(language).name << ": " << text;
        }
    }
}

std::string nameOf(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, LessonTexts, testing::ValuesIn(lesson::builtInLessons()), nameOf);

TEST(LessonTitles, AreThoseOfTheLanguage) {
    const std::vector<LessonTitle>& english = lessonTitles(Language::English);
    const std::vector<LessonTitle>& russian = lessonTitles(Language::Russian);
    ASSERT_EQ(english.size(), lesson::builtInLessons().size());
    ASSERT_EQ(russian.size(), english.size());
    for (std::size_t i = 0; i < english.size(); ++i) {
        EXPECT_EQ(russian[i].name, english[i].name);
        EXPECT_NE(russian[i].title, english[i].title);
        EXPECT_EQ(russian[i].steps, english[i].steps);
    }
}

} // namespace
} // namespace texplorer::ui::lesson_run_test
