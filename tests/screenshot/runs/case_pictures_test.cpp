#include "app/screenshot/runs/case_pictures.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace texplorer::screenshot::case_pictures_test {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

Image filled(int width, int height, std::byte value) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    std::ranges::fill(image.pixels, value);
    return image;
}

void put(const fs::path& file) {
    ASSERT_TRUE(writeFileAtomically(file, viewBytes("another user's")));
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& each : fs::directory_iterator(folder))
        names.push_back(each.path().filename());
    return names;
}

class CasePicturesTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(pictures); }

    test::TempDir folder;
    fs::path pictures = folder / picturesFolder;
};

TEST_F(CasePicturesTest, ThoseThatThereAreAreWrittenWithTheirPixels) {
    const Image actual = filled(3, 2, std::byte{200});
    const Image expected = filled(3, 2, std::byte{100});
    suite::CaseRecord record;
    ASSERT_TRUE(
        writePictures(folder.path(), "wrap__fixed@3x2", {.expected = &expected, .actual = &actual}, record));
    EXPECT_EQ(record.expectedPicture, "pictures/wrap__fixed@3x2-expected.png");
    EXPECT_EQ(record.actualPicture, "pictures/wrap__fixed@3x2-actual.png");
    EXPECT_EQ(record.differencePicture, "");
    EXPECT_THAT(namesIn(pictures),
                UnorderedElementsAre("wrap__fixed@3x2-expected.png", "wrap__fixed@3x2-expected.png.js",
                                     "wrap__fixed@3x2-actual.png", "wrap__fixed@3x2-actual.png.js"));
    const Result<Image> read = decodeImage(*readFile(folder / record.actualPicture));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->pixels, actual.pixels);
}

TEST_F(CasePicturesTest, LinkInTheirPlaceIsReplacedAndNotFollowed) {
    put(folder / "outside");
    fs::create_symlink(folder / "outside", pictures / "a-actual.png");
    const Image image = filled(1, 1, std::byte{1});
    suite::CaseRecord record;
    ASSERT_TRUE(writePictures(folder.path(), "a", {.actual = &image}, record));
    EXPECT_FALSE(fs::is_symlink(pictures / "a-actual.png"));
    EXPECT_EQ(*readText(folder / "outside"), "another user's");
}

TEST_F(CasePicturesTest, WhatAnotherRunLeftGoesAndNothingElse) {
    for (const char* name :
         {"a-actual.png", "a-actual.png.js", "b-difference.png", "notes.txt", "own.png", ".x-actual.png"})
        put(pictures / name);
    put(folder / "b-actual.png");
    fs::create_directory(pictures / "folder-actual.png");
    removePictures(folder.path());
    EXPECT_THAT(namesIn(pictures),
                UnorderedElementsAre("notes.txt", "own.png", ".x-actual.png", "folder-actual.png"));
    EXPECT_TRUE(fs::exists(folder / "b-actual.png"));
    removePictures(folder / "nowhere");
}

TEST_F(CasePicturesTest, PicturesOfTheseCasesStay) {
    for (const char* name : {"a-actual.png", "a-actual.png.js", "b-actual.png"})
        put(pictures / name);
    const suite::CaseRecord kept{.name = "a", .actualPicture = "pictures/a-actual.png"};
    removePictures(folder.path(), {&kept, 1});
    EXPECT_THAT(namesIn(pictures), UnorderedElementsAre("a-actual.png", "a-actual.png.js"));
}

TEST_F(CasePicturesTest, CopiesFollowOnlyNamesThatAreTheirs) {
    const test::TempDir target;
    fs::create_directory(target / picturesFolder);
    const Image image = filled(2, 2, std::byte{7});
    suite::CaseRecord record;
    ASSERT_TRUE(writePictures(folder.path(), "a", {.actual = &image}, record));
    record.expectedPicture = "pictures/../pictures/a-actual.png";
    record.differencePicture = "pictures/gone-difference.png";
    put(folder / "b-actual.png");
    std::vector<std::string> problems;
    ASSERT_TRUE(copyPictures(folder.path(), target.path(), record, problems));
    EXPECT_EQ(problems, std::vector<std::string>()) << "that a picture is missing is no problem";
    EXPECT_EQ(record.actualPicture, "pictures/a-actual.png");
    EXPECT_EQ(record.expectedPicture + record.differencePicture, "");
    EXPECT_THAT(namesIn(target / picturesFolder), UnorderedElementsAre("a-actual.png", "a-actual.png.js"));
    for (const std::string name :
         {"b-actual.png", "../b-actual.png", "/etc/x-actual.png", "pictures/notes.txt"}) {
        suite::CaseRecord wrong{.name = "a", .actualPicture = name};
        ASSERT_TRUE(copyPictures(folder.path(), target.path(), wrong, problems));
        EXPECT_EQ(wrong.actualPicture, "") << name;
    }
    EXPECT_THAT(namesIn(target.path()), UnorderedElementsAre(picturesFolder));
}

TEST_F(CasePicturesTest, CopiesTakePngFilesAndNothingThatALinkLeadsTo) {
    const test::TempDir target;
    fs::create_directory(target / picturesFolder);
    const Image image = filled(2, 2, std::byte{7});
    ASSERT_TRUE(writeFileAtomically(folder / "outside.png", *encodePng(image)));
    fs::create_symlink(folder / "outside.png", pictures / "link-actual.png");
    put(pictures / "text-actual.png");
    ASSERT_EQ(::mkfifo((pictures / "pipe-actual.png").c_str(), 0600), 0);
    for (const std::string name : {"link", "text", "pipe"}) {
        suite::CaseRecord record{.name = "a", .actualPicture = "pictures/" + name + "-actual.png"};
        std::vector<std::string> problems;
        ASSERT_TRUE(copyPictures(folder.path(), target.path(), record, problems));
        EXPECT_EQ(record.actualPicture, "") << name;
        ASSERT_EQ(problems.size(), 1U) << name;
        EXPECT_THAT(problems.front(), testing::HasSubstr("expected a PNG file")) << name;
        EXPECT_THAT(problems.front(), testing::HasSubstr(name + "-actual.png"));
    }
    EXPECT_THAT(namesIn(target / picturesFolder), IsEmpty());
}

} // namespace
} // namespace texplorer::screenshot::case_pictures_test
