// What the window of a released version wrote, tests/fixtures/released/VERSION: settings with the workspace,
// recent files, the answers of lessons; and the translation of a lesson. tests/core/released_files_test.cpp
// has the scenes.

#include "app/ui/files/answers.h"
#include "app/ui/language/lesson_catalogue.h"
#include "app/ui/services/settings_file.h"
#include "app/ui/services/settings_json.h"
#include "app/ui/state/lesson_records.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"

#include <nlohmann/json.hpp>

namespace texplorer::ui::released_files_test {
namespace {

namespace fs = std::filesystem;

const fs::path releases = fs::path(TEXPLORER_SOURCE_DIR) / "tests/fixtures/released";

std::string textIn(const fs::path& file) {
    const Result<std::string> text = readText(file);
    EXPECT_TRUE(text) << describe(text.error());
    return text.value_or("");
}

/// Settings as a window reads them, from copies: a file that can't be read would be renamed.
Settings settingsOf(const fs::path& release) {
    const texplorer::test::TempDir copies;
    fs::copy(release / "settings.json", copies / "settings.json");
    fs::copy(release / "recent.json", copies / "recent.json");
    SettingsFile file({copies / "settings.json", copies / "recent.json"});
    Settings settings = file.read();
    EXPECT_EQ(file.takeProblem(), std::nullopt);
    return settings;
}

TEST(ReleasedSettings, OpenWithTheirValues) {
    Settings expected;
    expected.theme = Theme::Light;
    expected.language = Language::Russian;
    expected.textPercent = 110;
    expected.glNames = true;
    expected.helpBelow = false;
    expected.hasSeenTour = true;
    expected.pinned = {"light.position", "textures[].internalFormat"};
    expected.recentFiles = {"/home/ann/lab/half 50%.texplorer.json", "/home/ann/lab/mesh.texplorer.json"};
    const StepRecord untouched{false, 0, -1};
    expected.lessons = {
        {"/home/ann/lab/lesson", {{true, 0, -1}, {true, 2, 0}, untouched, untouched, untouched}},
        {"wrap", {{true, 0, -1}, {false, 2, 2}, untouched, untouched, untouched, untouched, untouched}}};
    Workspace& workspace = expected.workspace;
    workspace.tabs[static_cast<std::size_t>(Tab::Lesson)] = {Dock::Right, true};
    workspace.tabs[static_cast<std::size_t>(Tab::File)] = {Dock::Right, true};
    workspace.tabs[static_cast<std::size_t>(Tab::Memory)] = {Dock::Below, false};
    workspace.front = {Tab::Lesson, Tab::Figures};
    workspace.seams = {338, 397, 0.49891067F, 0.33467743F};
    EXPECT_EQ(settingsOf(releases / "0.1.0"), expected);
}

TEST(ReleasedSettings, HaveNoUnknownValues) {
    for (const fs::directory_entry& release : fs::directory_iterator(releases)) {
        if (!fs::exists(release.path() / "settings.json"))
            continue;
        std::vector<std::string> leftOut;
        EXPECT_TRUE(parseSettings(textIn(release.path() / "settings.json"), leftOut)) << release;
        EXPECT_TRUE(parseRecentFiles(textIn(release.path() / "recent.json"), leftOut)) << release;
        EXPECT_THAT(leftOut, testing::IsEmpty()) << release;
    }
}

class ReleasedAnswers : public test::Workbench {};

/// Without the titles of steps, which may be worded differently.
nlohmann::json withoutTitles(const std::string& answers) {
    nlohmann::json json = nlohmann::json::parse(answers);
    for (nlohmann::json& lesson : json["answers"]) {
        for (nlohmann::json& step : lesson["steps"])
            step.erase("title");
    }
    return json;
}

// Programs of teachers read them.
TEST_F(ReleasedAnswers, AreWrittenInTheSameWay) {
    const fs::path release = releases / "0.1.0";
    session->settings = settingsOf(release);
    EXPECT_EQ(withoutTitles(answersText(session->settings)), withoutTitles(textIn(release / "answers.json")));
    EXPECT_TRUE(isStepDone(session->settings, "/home/ann/lab/lesson", 1));
    EXPECT_EQ(progressOf(session->settings, "wrap", 7).done, 1U);
}

TEST_F(ReleasedAnswers, ComeWithAWorkspaceThatIsShown) {
    session->settings = settingsOf(releases / "0.1.0");
    session->settings.language = Language::English;
    frames(3);
    EXPECT_TRUE(isShown(session->settings.workspace, Tab::Figures));
    EXPECT_EQ(frontOf(session->settings.workspace, Dock::Right), Tab::Lesson);
    expectSoundFrame();
}

TEST(ReleasedLesson, IsTranslated) {
    const auto folder = lesson::LessonFolder::onDisk(releases / "0.1.0/lesson");
    const Result<std::shared_ptr<const Catalogue>> catalogue = readLessonCatalogue(folder, Language::Russian);
    ASSERT_TRUE(catalogue) << describe(catalogue.error());
    ASSERT_TRUE(*catalogue);
    EXPECT_EQ(textIn(catalogue->get(), "Every kind of step"), "Шаги всех видов");
    EXPECT_EQ(textIn(catalogue->get(), "The marked pixel is {color}."), "Отмеченный пиксель — {color}.");
}

} // namespace
} // namespace texplorer::ui::released_files_test
