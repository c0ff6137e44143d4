// A lesson of a folder in the window: opened, edited meanwhile, dropped, and its answers saved.

#include "app/ui/editor/received_files.h"
#include "app/ui/files/answers.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/model/lesson_run.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"

#include <fmt/core.h>

#include <array>
#include <set>
#include <utility>

namespace texplorer::ui::lesson_folder_test {
namespace {

using namespace test;
using testing::HasSubstr;

/// Files whose changes are told by the test.
class ToldFiles final : public FilesAtOnce {
public:
    void watch(std::vector<std::filesystem::path> files) override { watched = std::move(files); }
    [[nodiscard]] std::vector<std::filesystem::path> changed() override { return std::exchange(told, {}); }

    std::vector<std::filesystem::path> watched;
    std::vector<std::filesystem::path> told;
};

/// A teacher's lesson of two steps, which is edited while it is open.
class LessonFolderInTheWindow : public Workbench {
protected:
    LessonFolderInTheWindow() {
        Services services = beside_.lend();
        services.files = files;
        lend(services);
        write("First text.", "textures[0].wrapS=GL_CLAMP");
        EXPECT_TRUE(openLesson(*session, lesson::LessonFolder::onDisk(folder.path()), 1));
        frames();
    }

    void write(const std::string& text, const std::string& edit) {
        writeRaw(folder / "lesson.json", fmt::format(R"({{"lesson": 1, "title": "Mine", "about": "About it.",
            "steps": [{{"title": "One", "text": "One.", "scene": "cube"}},
                      {{"title": "Two", "text": "{}", "edits": ["{}"], "try": "Do it."}}]}})",
                                                     text, edit));
    }
    void tell(const std::string& name) {
        files.told = {folder / name};
        (void)receiveFiles(*session);
        frames();
    }
    [[nodiscard]] const LessonRun& run() const { return *session->lesson; }

    TempDir folder;
    ToldFiles files;

private:
    ServicesAtOnce beside_;
};

TEST_F(LessonFolderInTheWindow, IsReadAgainWhenItsTextChangesAndWhatWasTriedStays) {
    (void)receiveFiles(*session);
    EXPECT_THAT(files.watched, testing::Contains(folder / "lesson.json"));
    texture().magFilter = MagFilter::Nearest;
    const Scene tried = scene();
    write("Second text.", "textures[0].wrapS=GL_CLAMP");
    tell("lesson.json");
    EXPECT_EQ(run().step, 1U);
    EXPECT_EQ(run().lesson.steps[1].text, "Second text.");
    EXPECT_EQ(scene(), tried);
}

TEST_F(LessonFolderInTheWindow, BeginsItsStepAnewWhenItsSceneChanges) {
    write("First text.", "textures[0].wrapS=GL_MIRRORED_REPEAT");
    tell("lesson.json");
    EXPECT_EQ(run().step, 1U);
    EXPECT_EQ(texture().wrapS, Wrap::MirroredRepeat);
}

TEST_F(LessonFolderInTheWindow, StaysAsItWasWhileItIsBrokenAndSaysWhere) {
    write("Second text.", "textures[0].nothing=1");
    tell("lesson.json");
    EXPECT_EQ(run().lesson.steps[1].text, "First text.");
    EXPECT_THAT(session->look.notice.text,
                HasSubstr("the lesson has changed and can't be read, so the old one stays: "));
    EXPECT_THAT(session->look.notice.text, HasSubstr("lesson.json: /steps/1/edits/0: "));
    writeRaw(folder / "lesson.json", std::string("{\"lesson\": 1,"));
    tell("lesson.json");
    EXPECT_THAT(session->look.notice.text, HasSubstr("can't be read, so the old one stays"));
    EXPECT_EQ(run().step, 1U);
    write("Third text.", "textures[0].wrapS=GL_CLAMP");
    tell("lesson.json");
    EXPECT_EQ(run().lesson.steps[1].text, "Third text.");
    EXPECT_EQ(session->look.notice.text, "");
}

TEST_F(LessonFolderInTheWindow, SaysInEveryLanguageWhatIsBroken) {
    const std::string head = R"({"lesson": 1, "title": "Mine", "about": "About it.", "steps": [)";
    const std::string step = R"({"title": "One", "text": "One.", "scene": "cube")";
    const std::string key = R"(, "keys": [{"key": "F", "label": "F")";
    const std::array broken{
        std::string("{"),
        std::string(R"({"lesson": 0, "title": "Mine"})"),
        std::string(R"({"lesson": 99, "title": "Mine", "about": "About it.", "steps": []})"),
        std::string(R"({"lesson": 1, "title": 5, "about": "About it.", "steps": []})"),
        head + R"({"title": "One", "text": "One."}]})",
        head + R"({"title": "One", "text": "One.", "scene": "../scene.json"}]})",
        head + R"({"title": "One", "text": "One.", "scene": "none"}]})",
        head + step + R"(, "look": {"probe": [1]}}]})",
        head + step + R"(, "edits": ["wrap"]}]})",
        head + step + R"(, "edits": ["textures[0].nothing=1"]}]})",
        head + step +
            R"(, "predict": {"question": "Why?", "answers": [{"text": "One"}, {"text": "Two"}], "right": 7}}]})",
        head + step + R"(, "try": "It.", "match": {"task": "It.", "edits": ["view.azimuth=1"]}}]})",
        head + step + "}]" + key + "}]}",
        head + step + "}]" + key + R"(, "path": "view.distance", "add": 0}]})",
    };
    for (const Language language : {Language::Chinese, Language::Russian}) {
        std::set<std::string, std::less<>> gaps;
        speak(language, &gaps);
        frames();
        const auto before = gaps; // symbols
        for (const std::string& text : broken) {
            writeRaw(folder / "lesson.json", text);
            session->look.notice.text = {};
            tell("lesson.json");
            EXPECT_THAT(session->look.notice.text, HasSubstr("can't be read")) << text;
        }
        EXPECT_EQ(gaps, before) << rowOf(language).name;
    }
}

TEST_F(LessonFolderInTheWindow, IsLeftAtItsLastStepWhereTheOneThatWasShownIsGone) {
    writeRaw(folder / "lesson.json", std::string(R"({"lesson": 1, "title": "Mine", "about": "About it.",
        "steps": [{"title": "One", "text": "One.", "scene": "cube"}]})"));
    tell("lesson.json");
    EXPECT_EQ(run().step, 0U);
}

TEST_F(LessonFolderInTheWindow, IsOpenedWhenItsFolderIsDropped) {
    closeLesson(*session);
    requestOpen(*session, {folder.path()});
    ASSERT_TRUE(session->lesson);
    EXPECT_EQ(run().lesson.title, "Mine");
}

TEST_F(LessonFolderInTheWindow, GivesItsAnswersAsAFile) {
    ASSERT_FALSE(session->settings.lessons.empty());
    const std::filesystem::path file = folder / "answers.json";
    ASSERT_TRUE(saveAnswers(session->settings, file));
    EXPECT_EQ(readRawText(file), answersText(session->settings));
    EXPECT_FALSE(saveAnswers(session->settings, folder / "missing" / "answers.json"));
}

TEST_F(LessonFolderInTheWindow, AsksForTheAnswersFileAndSaysWhereItIs) {
    click("menu:Lessons");
    click("menu:Save my answers…");
    frames(2);
    ASSERT_EQ(session->asking.dialog, Dialog::SaveAnswers);
    const std::filesystem::path file = folder / "mine.json";
    key('A', {ctrl}); // all of the name that is proposed
    type(file.string());
    click("browser:ok");
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_EQ(session->look.notice.text, "Written: " + file.string());
    EXPECT_TRUE(session->look.notice.isGood);
}

} // namespace
} // namespace texplorer::ui::lesson_folder_test
