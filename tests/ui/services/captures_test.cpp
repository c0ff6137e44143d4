#include "app/ui/services/captures.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace texplorer::captures_test {
namespace {

using namespace ui;
using testing::HasSubstr;

Image twoPixels() {
    Image image = Image::uninitialised(PixelFormat::Rgba8, 1, 2);
    image.pixels = Bytes{std::byte{255}, std::byte{0},   std::byte{0}, std::byte{255},
                         std::byte{0},   std::byte{255}, std::byte{0}, std::byte{255}};
    return image;
}

TEST(Captures, HaveANameThatIsFree) {
    const test::TempDir folder;
    Captures captures(folder.path());
    EXPECT_FALSE(captures.takeNews());
    for (const char* name : {"view.png", "view-2.png"}) {
        captures.write("view", twoPixels());
        const std::optional<Captures::News> news = captures.takeNews();
        ASSERT_TRUE(news);
        EXPECT_TRUE(news->isWritten);
        EXPECT_THAT(news->text, HasSubstr((folder.path() / name).string()));
        EXPECT_FALSE(captures.takeNews());
        const Bytes file = readFile(folder.path() / name).value();
        const Image written = decodeImage(file).value();
        EXPECT_EQ(written.width, 1);
        EXPECT_EQ(written.height, 2);
        EXPECT_EQ(written.at(0, 0)[0], std::byte{255}); // the lower one is red
        EXPECT_EQ(written.at(0, 1)[1], std::byte{255});
    }
}

TEST(Captures, MakeTheirFolder) {
    const test::TempDir folder;
    Captures captures(folder.path() / "Media" / "Pictures");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "Media")) << "not before there is a picture";
    captures.write("view", twoPixels());
    EXPECT_TRUE(captures.takeNews()->isWritten);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "Media" / "Pictures" / "view.png"));
}

/// What is in the way goes between the two pictures: the first one fails, and that is what one has to know.
TEST(Captures, AFailureIsNotHiddenByWhatCameAfterIt) {
    const test::TempDir folder;
    ASSERT_TRUE(writeFileAtomically(folder.path() / "missing", Bytes{}));
    Captures captures(folder.path() / "missing");
    captures.write("view", twoPixels());
    std::filesystem::remove(folder.path() / "missing");
    captures.write("view", twoPixels());
    const std::optional<Captures::News> news = captures.takeNews();
    ASSERT_TRUE(news);
    EXPECT_FALSE(news->isWritten);
    EXPECT_THAT(news->text, HasSubstr("can't be written"));
}

struct UserDirs {
    const char* text;
    const char* folder;
};

TEST(PicturesFolder, IsTheOneThatTheUserHas) {
    for (const UserDirs& row :
         {UserDirs{"", ""}, UserDirs{"XDG_PICTURES_DIR=\"$HOME/Bilder\"\n", "/home/u/Bilder"},
          UserDirs{"# a note\nXDG_MUSIC_DIR=\"$HOME/Music\"\nXDG_PICTURES_DIR=\"/data/p\"", "/data/p"},
          UserDirs{"XDG_PICTURES_DIR=\"relative\"", ""}, UserDirs{"#XDG_PICTURES_DIR=\"$HOME/p\"", ""}})
        EXPECT_EQ(picturesFolderIn(row.text, "/home/u"), row.folder) << row.text;
}

/// Sets an environment variable, or takes it away, while it lives.
class Variable {
public:
    Variable(const char* name, const char* value)
        : name_(name) {
        if (const char* before = std::getenv(name))
            before_ = before;
        if (value)
            ::setenv(name, value, 1);
        else
            ::unsetenv(name);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() {
        if (before_)
            ::setenv(name_, before_->c_str(), 1);
        else
            ::unsetenv(name_);
    }

private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(PicturesFolder, IsBelowHomeWhereTheUserNamesNone) {
    const test::TempDir folder;
    const Variable config("XDG_CONFIG_HOME", (folder.path() / "config").c_str());
    {
        const Variable home("HOME", folder.path().c_str());
        EXPECT_EQ(picturesFolderOfUser(), folder.path() / "Pictures");
        std::filesystem::create_directory(folder.path() / "config");
        const std::string text = "XDG_PICTURES_DIR=\"$HOME/Media/Bilder\"\n";
        ASSERT_TRUE(writeFileAtomically(folder.path() / "config" / "user-dirs.dirs", viewBytes(text)));
        EXPECT_EQ(picturesFolderOfUser(), folder.path() / "Media" / "Bilder") << "it needn't be there yet";
        std::filesystem::remove(folder.path() / "config" / "user-dirs.dirs");
    }
    const Variable none("HOME", nullptr);
    EXPECT_EQ(picturesFolderOfUser(), std::filesystem::current_path());
    const Variable gone("HOME", (folder.path() / "gone").c_str());
    EXPECT_EQ(picturesFolderOfUser(), std::filesystem::current_path());
}

} // namespace
} // namespace texplorer::captures_test
