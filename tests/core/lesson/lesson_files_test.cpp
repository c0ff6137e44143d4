#include "core/base/file_io.h"
#include "core/lesson/lesson_check.h"
#include "tests/support/temp_dir.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <sys/stat.h>

namespace texplorer::lesson::lesson_files_test {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;

constexpr std::string_view smallest =
    R"({"lesson": 1, "title": "L", "about": "A",
        "steps": [{"title": "S", "text": "T", "scene": "cube"}]})";

void write(const fs::path& file, std::string_view text) {
    ASSERT_TRUE(writeFileAtomically(file, viewBytes(text)));
}

TEST(BuiltInLessons, AreEnoughOfThem) {
    std::size_t steps = 0;
    for (const std::string& name : builtInLessons())
        steps += readLesson(*LessonFolder::builtIn(name)).value().steps.size();
    EXPECT_GE(builtInLessons().size(), 12U);
    EXPECT_GE(steps, 60U);
}

TEST(BuiltInLessons, BeginWithTheFirstTexture) {
    ASSERT_FALSE(builtInLessons().empty());
    EXPECT_EQ(builtInLessons().front(), "first-texture");
    EXPECT_EQ(builtInLessons().back(), "laboratory");
}

TEST(BuiltInLessons, AreNamedWhereOneIsNotAmongThem) {
    for (const char* name : {"nothing", "", "../wrap", "wrap/lesson.json"}) {
        const Result<LessonFolder> folder = LessonFolder::builtIn(name);
        ASSERT_FALSE(folder) << name;
        EXPECT_EQ(folder.error().code, ErrorCode::NotFound);
        EXPECT_THAT(folder.error().message, HasSubstr("expected one of first-texture, "));
    }
}

/// Each is a row of its own, as it takes a second: all its pictures are drawn.
class BuiltInLesson : public testing::TestWithParam<std::string> {};

TEST_P(BuiltInLesson, HasNothingWrong) {
    const LessonFolder folder = LessonFolder::builtIn(GetParam()).value();
    EXPECT_EQ(folder.path(), "");
    const Result<Lesson> lesson = readLesson(folder);
    ASSERT_TRUE(lesson) << describe(lesson.error());
    for (const Error& problem : checkLesson(folder, *lesson))
        ADD_FAILURE() << describe(problem);
}

std::string nameOf(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltInLesson, testing::ValuesIn(builtInLessons()), nameOf);

class FolderOnDisk : public testing::Test {
protected:
    FolderOnDisk() {
        fs::create_directory(path);
        write(parent / "secret.json", "{}");
    }

    [[nodiscard]] LessonFolder folder() const { return LessonFolder::onDisk(path); }
    [[nodiscard]] Error problem() const {
        const Result<Lesson> lesson = readLesson(folder());
        return lesson ? Error{ErrorCode::Cancelled, "", ""} : lesson.error();
    }

    texplorer::test::TempDir parent;
    fs::path path = parent / "mine";
};

TEST_F(FolderOnDisk, IsRead) {
    write(path / "lesson.json", smallest);
    const Result<Lesson> lesson = readLesson(folder());
    ASSERT_TRUE(lesson) << describe(lesson.error());
    EXPECT_EQ(lesson->title, "L");
    EXPECT_EQ(folder().name(), "mine");
    EXPECT_EQ(LessonFolder::onDisk(path / "").name(), "mine") << "with a slash at its end";
    EXPECT_TRUE(folder().has("lesson.json"));
    EXPECT_FALSE(folder().has("zh_CN.po"));
}

TEST_F(FolderOnDisk, WithoutALessonSaysSo) {
    EXPECT_EQ(problem().code, ErrorCode::NotFound);
    EXPECT_THAT(problem().where, EndsWith("mine/lesson.json"));
    fs::remove(path);
    EXPECT_EQ(problem().code, ErrorCode::NotFound);
}

TEST_F(FolderOnDisk, SaysFileAndPlaceOfAMistake) {
    write(path / "lesson.json", "{\"lesson\": 1,\n\"title\": \"L\",\n}");
    EXPECT_EQ(problem().code, ErrorCode::Malformed);
    EXPECT_THAT(problem().where, EndsWith("mine/lesson.json"));
    EXPECT_THAT(problem().message, HasSubstr("line 3"));
    write(path / "lesson.json", R"({"lesson": 1, "title": "L", "about": "A", "stpes": []})");
    EXPECT_THAT(problem().message, HasSubstr("/steps"));
    write(path / "lesson.json", std::string(maxLessonBytes + 1, ' '));
    EXPECT_EQ(problem().code, ErrorCode::TooLarge);
}

TEST_F(FolderOnDisk, MayHoldAnythingElse) {
    write(path / "lesson.json", smallest);
    for (int i = 0; i < 10'000; ++i)
        ASSERT_TRUE(fs::create_directory(path / std::to_string(i)));
    const Result<Lesson> lesson = readLesson(folder());
    ASSERT_TRUE(lesson) << describe(lesson.error());
    EXPECT_TRUE(checkLesson(folder(), *lesson).empty());
}

TEST_F(FolderOnDisk, IsNotLeft) {
    for (const char* name : {"../secret.json", "..", ".", "", "/etc/passwd", "a/b", "./lesson.json"}) {
        const Result<Bytes> bytes = folder().read(name);
        ASSERT_FALSE(bytes) << name;
        EXPECT_EQ(bytes.error().code, ErrorCode::OutOfRange) << name;
        EXPECT_EQ(bytes.error().where, name);
        EXPECT_FALSE(LessonFolder::builtIn("wrap")->read(name)) << name;
    }
}

TEST_F(FolderOnDisk, IsNotLeftByALink) {
    fs::create_symlink("../secret.json", path / "lesson.json");
    EXPECT_EQ(problem().code, ErrorCode::OutOfRange);
    EXPECT_THAT(problem().message + problem().where, HasSubstr("lesson.json"));
    fs::remove(path / "lesson.json");
    fs::create_symlink("nowhere", path / "lesson.json");
    EXPECT_FALSE(readLesson(folder()));
    fs::remove(path / "lesson.json");
    write(path / "first.json", smallest);
    fs::create_symlink("first.json", path / "lesson.json");
    EXPECT_TRUE(readLesson(folder())) << "one within the folder is as good as the file";
}

TEST_F(FolderOnDisk, MayBeReachedByALinkItself) {
    write(path / "lesson.json", smallest);
    fs::create_directory_symlink("mine", parent / "linked");
    EXPECT_TRUE(readLesson(LessonFolder::onDisk(parent / "linked")));
}

/// Nobody waits for a pipe that nobody writes.
TEST_F(FolderOnDisk, WithAPipeInPlaceOfTheLessonSaysSo) {
    ASSERT_EQ(::mkfifo((path / "lesson.json").c_str(), 0600), 0);
    EXPECT_FALSE(readLesson(folder()));
}

} // namespace
} // namespace texplorer::lesson::lesson_files_test
