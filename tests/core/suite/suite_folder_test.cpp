#include "tests/support/temp_dir.h"
#include "texplorer/suite/suite_folder.h"

#include <gmock/gmock.h>

#include <fstream>

namespace texplorer::suite::suite_folder_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

void write(const fs::path& file, std::string_view text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

constexpr std::string_view smallSuite = R"({"suite": 1, "cases": [{}]})";

/// The first bytes of a PNG of 3 x 2 pixels: its signature, and IHDR with both extents.
constexpr std::string_view pngStart{"\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\3\0\0\0\2", 24};

TEST(SuiteFolder, HasEverySuiteBelowIt) {
    const test::TempDir folder;
    write(folder / "b.suite.json", smallSuite);
    write(folder / "sub/a.suite.json", smallSuite);
    write(folder / "sub/scene.json", "{}");
    const Result<std::vector<Suite>> suites = suitesAt(folder.path());
    ASSERT_TRUE(suites) << describe(suites.error());
    ASSERT_EQ(suites->size(), 2U);
    EXPECT_EQ((*suites)[0].name, "b");
    EXPECT_EQ((*suites)[1].name, "sub/a");
    EXPECT_EQ((*suites)[1].folder, folder / "sub");
}

TEST(SuiteFolder, ASceneThatLostItsPictureIsNew) {
    const test::TempDir folder;
    write(folder / "alone.json", R"({"version": 1})");
    write(folder / "package.json", R"({"name": "x", "version": "1.0.0"})");
    write(folder / "half.json", R"({"version": 1)");
    const Result<std::vector<Suite>> suites = suitesAt(folder.path());
    ASSERT_TRUE(suites) << describe(suites.error());
    const std::vector<Entry>& entries = suites->front().entries;
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].name, "alone");
    EXPECT_THAT(entries[0].settings.sizes, ElementsAre(PictureSize{512, 512}));
    EXPECT_EQ(entries[0].settings.golden, (Golden{GoldenFiles{{{"*", {"alone.png"}}}}}));
}

TEST(SuiteFolder, WithoutASuiteIsOneOfScenesAndTheirPictures) {
    const test::TempDir folder;
    write(folder / "x.json", "{}");
    write(folder / "x.png", pngStart);
    write(folder / "sub/y.json", "{}");
    write(folder / "sub/y.png", "no PNG");
    write(folder / "package.json", R"({"name": "no scene"})");
    write(folder / "alone-too.png", pngStart);
    const Result<std::vector<Suite>> suites = suitesAt(folder.path());
    ASSERT_TRUE(suites) << describe(suites.error());
    ASSERT_EQ(suites->size(), 1U);
    const std::vector<Entry>& entries = suites->front().entries;
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].name, "sub/y");
    EXPECT_THAT(entries[0].settings.sizes, ElementsAre(PictureSize{})); // what it is, its comparison says
    EXPECT_EQ(entries[1].name, "x");
    EXPECT_THAT(entries[1].scenes, ElementsAre(SceneSource{SceneFile{"x.json"}}));
    EXPECT_THAT(entries[1].settings.sizes, ElementsAre(PictureSize{3, 2}));
    EXPECT_EQ(entries[1].settings.golden, (Golden{GoldenFiles{{{"*", {"x.png"}}}}}));
}

TEST(SuiteFolder, WithNeitherSaysSo) {
    const test::TempDir folder;
    const Result<std::vector<Suite>> none = suitesAt(folder.path());
    ASSERT_FALSE(none);
    EXPECT_THAT(describe(none.error()), HasSubstr("expected a suite, *.suite.json, or scenes X.json"));
    const Result<std::vector<Suite>> absent = suitesAt(folder / "absent");
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().code, ErrorCode::NotFound);
}

TEST(SuiteFolder, WhatShouldBeASuiteAndIsNoneIsAnError) {
    const test::TempDir folder;
    write(folder / "a.suite.json", smallSuite);
    fs::create_symlink("nowhere", folder / "b.suite.json");
    EXPECT_THAT(describe(suitesAt(folder.path()).error()), HasSubstr("b.suite.json: expected a suite file"));
    fs::remove(folder / "b.suite.json");
    fs::create_directory(folder / "c.suite.json");
    EXPECT_THAT(describe(suitesAt(folder.path()).error()), HasSubstr("c.suite.json: expected a suite file"));
}

TEST(SuiteFolder, LinksAreNotEntered) {
    const test::TempDir outside;
    const test::TempDir folder;
    write(outside / "b.suite.json", smallSuite);
    write(folder / "a.suite.json", smallSuite);
    fs::create_directory_symlink(outside.path(), folder / "link");
    fs::create_directory_symlink(folder.path(), folder / "loop");
    const Result<std::vector<Suite>> suites = suitesAt(folder.path());
    ASSERT_TRUE(suites) << describe(suites.error());
    EXPECT_EQ(suites->size(), 1U);
}

TEST(SuiteFolder, ASuiteThatIsBrokenIsNamed) {
    const test::TempDir folder;
    write(folder / "sub/a.suite.json", "{");
    const Result<std::vector<Suite>> suites = suitesAt(folder.path());
    ASSERT_FALSE(suites);
    EXPECT_EQ(suites.error().where, (folder / "sub/a.suite.json").string() + ": line 1, column 2");
}

TEST(SuiteFolder, NamesStayInside) {
    for (const char* name : {"a", "a/b.png", "a..b", "..a", "a/.b", "a/./b"})
        EXPECT_TRUE(checkInside(name)) << name;
    for (const char* name : {"", "/a", "..", "../a", "a/../b", "a/..", "a\\b", "a\nb"})
        EXPECT_FALSE(checkInside(name)) << name;
}

TEST(SuiteFolder, LinksOnTheDiskStayInsideToo) {
    const test::TempDir outside;
    const test::TempDir folder;
    write(outside / "secret.png", "x");
    write(folder / "golden/a.png", "x");
    fs::create_symlink(outside / "secret.png", folder / "out.png");
    fs::create_symlink(outside / "new.png", folder / "nowhere.png"); // writing would make it there
    fs::create_directory_symlink(outside.path(), folder / "away");
    fs::create_symlink("golden/a.png", folder / "in.png");
    EXPECT_TRUE(pathInside(folder.path(), "golden/a.png"));
    EXPECT_TRUE(pathInside(folder.path(), "golden/new.png"));
    EXPECT_TRUE(pathInside(folder.path(), "in.png"));
    for (const char* name : {"out.png", "nowhere.png", "away/b.png"})
        EXPECT_FALSE(pathInside(folder.path(), name)) << name;
}

/// Nothing of it is there, as of a golden that is to be written.
TEST(PathInside, MayNameWhatIsNotThereYet) {
    const test::TempDir folder;
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::create_directory(folder / "suite");
    std::filesystem::current_path(folder.path());
    for (const char* relative : {"", ".", "suite", "absent"})
        EXPECT_TRUE(pathInside(relative, "golden/absent.png")) << relative;
    EXPECT_FALSE(checkStays("suite", "golden/absent.png"));
    EXPECT_TRUE(checkStays("suite", "suite/../suite/absent.png"));
    std::filesystem::current_path(here);
}

} // namespace
} // namespace texplorer::suite::suite_folder_test
