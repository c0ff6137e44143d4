#include "tests/support/temp_dir.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/lesson_check.h"
#include "texplorer/lesson/lesson_files.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <fmt/core.h>
#include <glm/glm.hpp>
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

/// One test for each lesson, because it takes a second: it draws all pictures.
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

/// Red, green and blue of all texels, weighted by alpha, and alpha.
glm::vec4 meanOf(const Surface& surface) {
    const Image image = toImage(surface);
    glm::vec4 sum{0};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto part = [texel = image.at(x, y)](std::size_t i) {
                return static_cast<float>(std::to_integer<int>(texel[i]));
            };
            sum += glm::vec4(part(0), part(1), part(2), 1) * part(3);
        }
    }
    return {glm::vec3(sum) / sum.a, sum.a / static_cast<float>(image.width * image.height)};
}

/// The levels of squares: the mean stays the same, except for what the four colours of a block, which lie on
/// a line, and the 16 values of DXT3's alpha cannot represent.
TEST(BuiltInLessons, HaveLevelsThatAreTheMeanOfTheOneBefore) {
    int pairs = 0;
    for (const LessonFile& file : lessonFiles()) {
        if (!file.name.ends_with(".dds"))
            continue;
        const Result<TextureImage> texture = decodeTexture(viewBytes(file.text));
        ASSERT_TRUE(texture) << file.name;
        for (int level = 1; level < texture->levels; ++level, ++pairs) {
            const glm::vec4 before = meanOf(texture->surface(0, level - 1));
            const glm::vec4 mean = meanOf(texture->surface(0, level));
            for (int part = 0; part < 4; ++part)
                EXPECT_NEAR(mean[part], before[part], 16) << file.name << " " << level << " " << part;
        }
    }
    EXPECT_GE(pairs, 30);
}

/// glTexImage2D gets the content of a file: columns of (255 - 32 x, 32 x, 0 and 200), two by two, then four
/// by four.
TEST(BuiltInLessons, HaveTheRightLevelsOfTheSmallRamp) {
    const auto ramp = std::ranges::find(lessonFiles(), "sizes/8x2.dds", &LessonFile::name);
    ASSERT_NE(ramp, lessonFiles().end());
    const TextureImage texture = decodeTexture(viewBytes(ramp->text)).value();
    constexpr int bitsLost = 8; // a step of 5 bits
    for (const int level : {1, 2}) {
        const Image image = toImage(texture.surface(0, level));
        ASSERT_EQ(image.width, 8 >> level);
        const int columns = 1 << level;
        for (int x = 0; x < image.width; ++x) {
            const int middle = 32 * x * columns + 16 * (columns - 1);
            EXPECT_NEAR(std::to_integer<int>(image.at(x, 0)[0]), 255 - middle, bitsLost) << level << " " << x;
            EXPECT_NEAR(std::to_integer<int>(image.at(x, 0)[1]), middle, bitsLost) << level << " " << x;
            EXPECT_NEAR(std::to_integer<int>(image.at(x, 0)[2]), 100, bitsLost) << level << " " << x;
        }
    }
}

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
    fs::create_directory(path / "zh_CN.po");
    EXPECT_TRUE(folder().has("zh_CN.po")) << "reading it says what it is";
    EXPECT_FALSE(folder().readText("zh_CN.po"));
}

TEST_F(FolderOnDisk, WithoutALessonSaysSo) {
    EXPECT_EQ(problem().code, ErrorCode::NotFound);
    EXPECT_THAT(problem().where.text(), EndsWith("mine/lesson.json"));
    fs::remove(path);
    EXPECT_EQ(problem().code, ErrorCode::NotFound);
}

TEST_F(FolderOnDisk, SaysFileAndPlaceOfAMistake) {
    write(path / "lesson.json", "{\"lesson\": 1,\n\"title\": \"L\",\n}");
    EXPECT_EQ(problem().code, ErrorCode::Malformed);
    EXPECT_THAT(problem().where.text(), EndsWith("mine/lesson.json: line 3, column 1"));
    EXPECT_THAT(problem().message, HasSubstr("expected a key in quotes"));
    write(path / "lesson.json", R"({"lesson": 1, "title": "L", "about": "A", "stpes": []})");
    EXPECT_THAT(problem().message, HasSubstr("expected the key \"steps\""));
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
    EXPECT_THAT(problem().message.english() + problem().where.text(), HasSubstr("lesson.json"));
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

/// Does not block on a pipe without a writer.
TEST_F(FolderOnDisk, WithAPipeInPlaceOfTheLessonSaysSo) {
    ASSERT_EQ(::mkfifo((path / "lesson.json").c_str(), 0600), 0);
    EXPECT_FALSE(readLesson(folder()));
}

} // namespace
} // namespace texplorer::lesson::lesson_files_test
