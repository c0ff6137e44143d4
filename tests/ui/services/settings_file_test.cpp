#include "app/ui/services/settings_file.h"
#include "app/ui/services/settings_json.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/folder_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <thread>

namespace texplorer::settings_file_test {
namespace {

using namespace ui;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Settings unusual() {
    Settings settings;
    settings.theme = Theme::HighContrast;
    settings.textPercent = 175;
    settings.glNames = true;
    settings.helpBelow = false;
    settings.hasSeenTour = true;
    settings.pinned = {"textures[].wrapR", "light.position"};
    settings.lessons = {{"wrap", {{true, 3, 1}, {}}}, {"Мой урок", {{false, 0, -1}}}};
    settings.workspace = workspaceOf(layoutRows.back());
    return settings;
}

/// All values must be known.
Settings settingsIn(std::string_view text) {
    std::vector<std::string> leftOut;
    Settings settings = parseSettings(text, leftOut).value();
    EXPECT_THAT(leftOut, IsEmpty());
    return settings;
}

TEST(Settings, ComeBackFromTheirText) {
    EXPECT_EQ(settingsIn(writeSettings(unusual())), unusual());
    EXPECT_EQ(settingsIn(writeSettings({})), Settings{});
    EXPECT_EQ(settingsIn("{}"), Settings{});
}

TEST(Settings, KeepWhatALaterVersionWrote) {
    const std::string text = writeSettings(unusual(), R"({"fromLater": [1, 2], "theme": "light"})");
    EXPECT_THAT(text, HasSubstr("fromLater"));
    EXPECT_EQ(settingsIn(text).theme, Theme::HighContrast);
}

TEST(Settings, AreRefusedIfTheyAreNoObject) {
    std::vector<std::string> leftOut;
    for (const std::string_view text : {"", "[1]", "{\"theme\"", R"({"textPercent": 1e400})"})
        EXPECT_FALSE(parseSettings(text, leftOut)) << text;
    EXPECT_EQ(parseSettings({"{}\0{}", 5}, leftOut).error().where, "line 1, column 3");
    EXPECT_FALSE(parseSettings(std::string(100'000, '['), leftOut));
}

struct Unknown {
    std::string_view text;
    const char* where;
};

TEST(Settings, SayWhereTheyAreWrong) {
    for (const Unknown& row :
         {Unknown{R"({"theme": "pink"})", "/theme"}, Unknown{R"({"theme": 3})", "/theme"},
          Unknown{R"({"textPercent": 74})", "/textPercent"},
          Unknown{R"({"textPercent": 251})", "/textPercent"},
          Unknown{R"({"textPercent": "big"})", "/textPercent"}, Unknown{R"({"glNames": 1})", "/glNames"},
          Unknown{R"({"pinned": [1]})", "/pinned/0"}, Unknown{R"({"lessons": []})", "/lessons"},
          Unknown{R"({"lessons": {"wrap": 3}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [true]}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [[true, 1]]}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [[1, 1, 1]]}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [[true, -1, 1]]}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [[true, 1e300, 1]]}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [[true, 99999999999999, 1]]}})", "/lessons/wrap"},
          Unknown{R"({"lessons": {"wrap": [[true, 1, -2]]}})", "/lessons/wrap"},
          Unknown{R"({"workspace": []})", "/workspace"}}) {
        std::vector<std::string> leftOut;
        EXPECT_EQ(parseSettings(row.text, leftOut).value(), Settings{}) << row.text;
        EXPECT_THAT(leftOut, ElementsAre(row.where)) << row.text;
    }
}

TEST(Settings, OneThatIsNotKnownIsLeftOutAlone) {
    std::vector<std::string> leftOut;
    const Settings settings = parseSettings(R"({"theme": "pink", "textPercent": 150, "glNames": 1,
        "pinned": ["a", 3, "b"],
        "lessons": {"wrap": [[true, 3, 1]], "odd": [[true, 1, 1], [2]]},
        "workspace": {"tabs": {"vertices": {"open": true}, "commands": {"dock": "moon"}}, "seams": 7}})",
                                            leftOut)
                                  .value();
    Settings expected;
    expected.textPercent = 150;
    expected.pinned = {"a", "b"};
    expected.lessons = {{"wrap", {{true, 3, 1}}}};
    expected.workspace.tabs[static_cast<std::size_t>(Tab::Vertices)].open = true;
    EXPECT_EQ(settings, expected);
    EXPECT_THAT(leftOut, ElementsAre("/theme", "/glNames", "/pinned/1", "/lessons/odd",
                                     "/workspace/tabs/commands/dock", "/workspace/seams"));
}

TEST(RecentFiles, ComeFirstWhenTheyAreOpened) {
    Settings settings;
    for (const char* file : {"/a", "/b", "/a"})
        rememberFile(settings, file);
    EXPECT_THAT(settings.recentFiles, ElementsAre("/a", "/b"));
    rememberFile(settings, "");
    EXPECT_EQ(settings.recentFiles.size(), 2U);
    for (int i = 0; i < 20; ++i)
        rememberFile(settings, "/" + std::to_string(i));
    EXPECT_EQ(settings.recentFiles.size(), maxRecentFiles);
    EXPECT_EQ(settings.recentFiles.front(), "/19");
    std::vector<std::string> leftOut;
    EXPECT_EQ(parseRecentFiles(writeRecentFiles(settings), leftOut).value(), settings.recentFiles);
    EXPECT_THAT(leftOut, IsEmpty());
}

TEST(RecentFiles, RefuseWhatIsNoListOfThem) {
    std::vector<std::string> leftOut;
    EXPECT_FALSE(parseRecentFiles("{}", leftOut));
    EXPECT_FALSE(parseRecentFiles("[", leftOut));
    EXPECT_THAT(parseRecentFiles(R"([1, "/a"])", leftOut).value(), ElementsAre("/a"));
    EXPECT_THAT(leftOut, ElementsAre("/0"));
}

/// On a clock that a test sets.
class KeptSettings : public testing::Test {
protected:
    [[nodiscard]] SettingsPlaces places() const {
        return {folder.path() / "config" / "settings.json", folder.path() / "state" / "recent.json"};
    }
    [[nodiscard]] SettingsFile open() {
        return SettingsFile(places(), {}, std::chrono::milliseconds(1000), [this] { return now; });
    }

    /// Writes the settings file as another program does.
    void put(std::string_view text) const {
        std::filesystem::create_directories(places().settings.parent_path());
        ASSERT_TRUE(writeFileAtomically(places().settings, viewBytes(text)));
    }
    /// A window with these settings.
    void window(const Settings& settings) {
        SettingsFile file = open();
        std::ignore = file.read();
        file.keep(settings);
    }

    test::TempDir folder;
    double now = 10;
};

TEST_F(KeptSettings, AreReadByTheNextWindow) {
    Settings settings = unusual();
    rememberFile(settings, "/scenes/earth.json");
    {
        SettingsFile file = open();
        EXPECT_EQ(file.read(), Settings{});
        EXPECT_FALSE(file.takeProblem());
        file.keep(settings);
    }
    EXPECT_EQ(open().read(), settings);
}

TEST_F(KeptSettings, AreWrittenAMomentAfterTheyChanged) {
    SettingsFile file = open();
    std::ignore = file.read();
    file.keep({});
    EXPECT_FALSE(file.due());
    file.keep(unusual());
    EXPECT_EQ(file.due(), 11.0);
    now = 10.5;
    file.keep(unusual());
    EXPECT_EQ(file.due(), 11.0);
    now = 11;
    file.keep(unusual());
    EXPECT_FALSE(file.due());
}

TEST_F(KeptSettings, NothingIsWrittenWhereNothingChanged) {
    {
        SettingsFile file = open();
        file.keep(file.read());
    }
    EXPECT_FALSE(std::filesystem::exists(places().settings));
}

TEST_F(KeptSettings, AFileThatCannotBeParsedIsSetAsideBesideThoseOfBefore) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"{\"theme\": \"light\"", ".broken"}, {"[1]", ".broken-2"}, {std::string("{}\0{}", 5), ".broken-3"}};
    for (const auto& [wrong, name] : files) {
        put(wrong);
        SettingsFile file = open();
        EXPECT_EQ(file.read(), Settings{});
        const std::optional<std::string> problem = file.takeProblem();
        ASSERT_TRUE(problem);
        EXPECT_THAT(*problem, HasSubstr("settings.json" + name + "."));
        EXPECT_FALSE(file.takeProblem());
        EXPECT_EQ(readText(places().settings.string() + name).value(), wrong);
    }
    EXPECT_EQ(readText(places().settings.string() + ".broken").value(), "{\"theme\": \"light\"");
}

/// It may hold valid settings.
TEST_F(KeptSettings, AFileThatCannotBeReadStaysWhereItIs) {
    std::filesystem::create_directories(places().settings); // root can read every file, but no folder
    std::filesystem::create_directories(places().recent.parent_path());
    ASSERT_TRUE(writeFileAtomically(places().recent, viewBytes("[1")));
    {
        SettingsFile file = open();
        Settings settings = file.read();
        EXPECT_EQ(settings, Settings{});
        EXPECT_THAT(file.takeProblem().value_or(""),
                    testing::AllOf(HasSubstr("Settings can't be read: "), HasSubstr("recent.json.broken")));
        settings.glNames = !settings.glNames;
        file.keep(settings);
    }
    EXPECT_TRUE(std::filesystem::is_directory(places().settings));
}

TEST_F(KeptSettings, AValueThatIsNotKnownIsLeftOutAndStaysInTheFile) {
    put(R"({"theme": "pink", "textPercent": 150})");
    {
        SettingsFile file = open();
        Settings settings = file.read();
        EXPECT_EQ(settings.textPercent, 150);
        EXPECT_EQ(settings.theme, Settings{}.theme);
        EXPECT_THAT(file.takeProblem().value_or(""), HasSubstr("/theme"));
        settings.glNames = !settings.glNames;
        file.keep(settings);
    }
    const std::string text = readText(places().settings).value();
    EXPECT_THAT(text, HasSubstr("pink"));
    EXPECT_THAT(text, HasSubstr("150"));
    EXPECT_FALSE(std::filesystem::exists(places().settings.string() + ".broken"));
}

TEST_F(KeptSettings, UnknownKeysSurviveAWindow) {
    put(R"({"fromLater": true})");
    window(unusual());
    EXPECT_THAT(readText(places().settings).value(), HasSubstr("fromLater"));
    EXPECT_EQ(open().read(), unusual());
}

/// Two windows are open; each changes something, and neither takes back what the other one did.
TEST_F(KeptSettings, TwoWindowsShareTheFiles) {
    Settings first;
    Settings second;
    first.pinned = {"a", "b"};
    first.recentFiles = {"/old"};
    window(first);
    {
        SettingsFile one = open();
        SettingsFile other = open();
        first = one.read();
        second = other.read();
        ASSERT_THAT(second.pinned, ElementsAre("a", "b"));
        first.theme = Theme::Light;
        first.pinned = {"b", "c"};
        rememberFile(first, "/one");
        second.textPercent = 150;
        second.pinned.emplace_back("d");
        rememberFile(second, "/other");
        one.keep(first);
        other.keep(second);
    } // the other one ends first
    const Settings last = open().read();
    EXPECT_EQ(last.theme, Theme::Light);
    EXPECT_EQ(last.textPercent, 150);
    EXPECT_THAT(last.pinned, ElementsAre("b", "d", "c"));
    EXPECT_THAT(last.recentFiles, ElementsAre("/one", "/other", "/old"));
}

// The one writes while the other is between reading and writing: it waits.
TEST_F(KeptSettings, WindowsThatWriteAtTheSameInstantLoseNothing) {
    std::filesystem::create_directories(places().settings.parent_path());
    auto lock = std::make_optional<FolderLock>(places().settings.parent_path());
    if (!lock->isHeld())
        GTEST_SKIP() << "there are no locks here";
    {
        SettingsFile file = open();
        Settings mine = file.read();
        mine.textPercent = 150;
        file.keep(mine);
        now += 2;
        file.keep(mine); // its worker begins
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        Settings other;
        other.theme = Theme::Light;
        put(writeSettings(other));
        lock.reset();
    }
    const Settings last = open().read();
    EXPECT_EQ(last.theme, Theme::Light);
    EXPECT_EQ(last.textPercent, 150);
}

TEST_F(KeptSettings, AreWrittenWithoutALockAfterAWhile) {
    const FolderLock lock(folder.path());
    if (!lock.isHeld())
        GTEST_SKIP() << "there are no locks here";
    EXPECT_FALSE(FolderLock(folder.path(), std::chrono::milliseconds(4)).isHeld());
    EXPECT_FALSE(FolderLock(folder.path() / "none").isHeld());
}

TEST_F(KeptSettings, WhatWasWrittenOnceIsNotWrittenAgain) {
    {
        SettingsFile one = open();
        Settings first = one.read();
        first.theme = Theme::Light;
        one.keep(first);
        now = 11;
        one.keep(first); // is written
        while (!std::filesystem::exists(places().settings))
            EXPECT_FALSE(one.takeProblem());
        {
            SettingsFile other = open();
            Settings second = other.read();
            EXPECT_EQ(second.theme, Theme::Light);
            second.theme = Theme::HighContrast;
            other.keep(second);
        }
        first.textPercent = 200;
        one.keep(first);
    }
    EXPECT_EQ(open().read().theme, Theme::HighContrast);
    EXPECT_EQ(open().read().textPercent, 200);
}

TEST_F(KeptSettings, ForgottenFilesStayForgotten) {
    Settings settings;
    settings.recentFiles = {"/a", "/b"};
    window(settings);
    {
        SettingsFile one = open();
        SettingsFile other = open();
        Settings first = one.read();
        Settings second = other.read();
        first.recentFiles.clear();
        rememberFile(second, "/c");
        rememberFile(second, "/b");
        one.keep(first);
        other.keep(second);
    }
    EXPECT_THAT(open().read().recentFiles, ElementsAre("/c"));
}

TEST_F(KeptSettings, AFolderThatCannotBeWrittenIsSaid) {
    ASSERT_TRUE(writeFileAtomically(folder.path() / "config", viewBytes("a file")));
    SettingsFile file({folder.path() / "config" / "settings.json", {}}, {}, std::chrono::milliseconds(0),
                      [this] { return now; });
    std::ignore = file.read();
    file.keep(unusual());
    std::optional<std::string> problem = file.takeProblem();
    while (!problem) // a thread writes
        problem = file.takeProblem();
    EXPECT_THAT(*problem, HasSubstr("Settings can't be saved"));
}

TEST_F(KeptSettings, WhatCouldNotBeWrittenIsTriedAgainAtTheEnd) {
    const std::filesystem::path config = folder.path() / "config";
    ASSERT_TRUE(writeFileAtomically(config, viewBytes("a file")));
    const SettingsPlaces inside{config / "settings.json", {}};
    {
        SettingsFile file(inside, {}, std::chrono::milliseconds(0), [this] { return now; });
        Settings settings = file.read();
        for (const int percent : {150, 175, 200}) { // none of them can be written
            settings.textPercent = percent;
            settings.glNames = percent == 150 || settings.glNames;
            file.keep(settings);
            while (!file.takeProblem())
                file.keep(settings);
        }
        std::filesystem::remove(config);
    }
    SettingsFile file(inside);
    const Settings last = file.read();
    EXPECT_EQ(last.textPercent, 200);
    EXPECT_TRUE(last.glNames) << "what the first write should have kept";
}

} // namespace
} // namespace texplorer::settings_file_test
