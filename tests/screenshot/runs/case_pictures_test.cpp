#include "app/screenshot/runs/case_pictures.h"
#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>

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
    ASSERT_TRUE(writeFileAtomically(file, viewBytes("somebody's")));
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
    EXPECT_EQ(*readText(folder / "outside"), "somebody's");
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

TEST_F(CasePicturesTest, CopiesFollowOnlyNamesThatAreTheirs) {
    const test::TempDir target;
    fs::create_directory(target / picturesFolder);
    const Image image = filled(2, 2, std::byte{7});
    suite::CaseRecord record;
    ASSERT_TRUE(writePictures(folder.path(), "a", {.actual = &image}, record));
    record.expectedPicture = "pictures/../pictures/a-actual.png";
    record.differencePicture = "pictures/gone-difference.png";
    put(folder / "b-actual.png");
    ASSERT_TRUE(copyPictures(folder.path(), target.path(), record));
    EXPECT_EQ(record.actualPicture, "pictures/a-actual.png");
    EXPECT_EQ(record.expectedPicture + record.differencePicture, "");
    EXPECT_THAT(namesIn(target / picturesFolder), UnorderedElementsAre("a-actual.png", "a-actual.png.js"));
    for (const std::string name :
         {"b-actual.png", "../b-actual.png", "/etc/x-actual.png", "pictures/notes.txt"}) {
        suite::CaseRecord wrong{.name = "a", .actualPicture = name};
        ASSERT_TRUE(copyPictures(folder.path(), target.path(), wrong));
        EXPECT_EQ(wrong.actualPicture, "") << name;
    }
    EXPECT_THAT(namesIn(target.path()), UnorderedElementsAre(picturesFolder));
}

} // namespace
} // namespace texplorer::screenshot::case_pictures_test
