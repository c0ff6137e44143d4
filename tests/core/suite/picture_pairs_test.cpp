#include "tests/support/temp_dir.h"
#include "texplorer/suite/picture_pairs.h"

#include <gmock/gmock.h>

#include <fstream>

namespace texplorer::suite::picture_pairs_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

void write(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
}

TEST(PicturePairs, AreOfTheSameName) {
    const test::TempDir actual;
    const test::TempDir golden;
    write(actual / "a.png");
    write(actual / "sub/b.PNG");
    write(actual / "extra.png");
    write(actual / "notes.txt");
    write(golden / "a.png");
    write(golden / "sub/b.PNG");
    write(golden / "sub/missing.png");
    const Result<std::vector<PicturePair>> pairs = pairPictures(actual.path(), golden.path());
    ASSERT_TRUE(pairs) << describe(pairs.error());
    EXPECT_THAT(*pairs, ElementsAre(PicturePair{"a.png", true, true}, PicturePair{"extra.png", true, false},
                                    PicturePair{"sub/b.PNG", true, true},
                                    PicturePair{"sub/missing.png", false, true}));
}

TEST(PicturePairs, NeedFoldersWithPictures) {
    const test::TempDir empty;
    write(empty / "a.txt");
    const Result<std::vector<PicturePair>> none = pairPictures(empty.path(), empty.path());
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().message, HasSubstr("found none in either folder"));
    EXPECT_EQ(pairPictures(empty / "absent", empty.path()).error().code, ErrorCode::NotFound);
    EXPECT_THAT(pairPictures(empty.path(), empty / "a.txt").error().message, HasSubstr("expected a folder"));
}

TEST(PicturePairs, HaveThePixelsOfTheLargerHeader) {
    const test::TempDir actual;
    const test::TempDir golden;
    const auto writePng = [](const fs::path& file, char width, char height) {
        const std::string start("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0", 19);
        std::ofstream(file) << start << width << std::string(3, '\0') << height;
    };
    writePng(actual / "a.png", 3, 2);
    writePng(golden / "a.png", 2, 5);
    const Result<std::vector<PicturePair>> pairs = pairPictures(actual.path(), golden.path());
    ASSERT_TRUE(pairs) << describe(pairs.error());
    EXPECT_THAT(*pairs, ElementsAre(PicturePair{"a.png", true, true, 10}));
}

TEST(PicturePairs, AReportAmongThemIsNoneOfThem) {
    const test::TempDir folder;
    write(folder / "a.png");
    fs::create_directories(folder / "report/pictures");
    write(folder / "report/pictures/a-actual.png");
    const Result<std::vector<PicturePair>> pairs =
        pairPictures(folder.path(), folder.path(), folder / "report");
    ASSERT_TRUE(pairs) << describe(pairs.error());
    EXPECT_THAT(*pairs, ElementsAre(PicturePair{"a.png", true, true}));
}

TEST(PicturePairs, LinksDontLeadOut) {
    const test::TempDir outside;
    const test::TempDir folder;
    write(outside / "secret.png");
    write(folder / "a.png");
    fs::create_symlink("a.png", folder / "same.png");
    fs::create_directory_symlink(outside.path(), folder / "away");
    fs::create_directory_symlink(folder.path(), folder / "loop");
    const Result<std::vector<PicturePair>> pairs = pairPictures(folder.path(), folder.path());
    ASSERT_TRUE(pairs) << describe(pairs.error());
    EXPECT_THAT(*pairs, ElementsAre(PicturePair{"a.png", true, true}, PicturePair{"same.png", true, true}));
    fs::create_symlink(outside / "secret.png", folder / "out.png");
    const Result<std::vector<PicturePair>> out = pairPictures(folder.path(), folder.path());
    ASSERT_TRUE(out) << describe(out.error());
    EXPECT_THAT(*out, Contains(PicturePair{"out.png", true, true})); // and refused when it is read
}

} // namespace
} // namespace texplorer::suite::picture_pairs_test
