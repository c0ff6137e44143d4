#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/private_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

namespace texplorer::private_directory_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Private : public testing::Test {
protected:
    test::TempDir folder;
    fs::path place = folder / "private";

    unsigned mode(const fs::path& path) const {
        struct stat info = {};
        EXPECT_EQ(::lstat(path.c_str(), &info), 0);
        return info.st_mode & 07777;
    }
    void expectRefused(const char* words) const {
        for (const auto& opened : {PrivateDirectory::open(place), PrivateDirectory::make(place)}) {
            ASSERT_FALSE(opened);
            EXPECT_EQ(opened.error().where, place.string());
            EXPECT_THAT(opened.error().message, HasSubstr(words));
        }
    }
};

TEST_F(Private, IsMadeWithWhatIsAboveIt) {
    const mode_t mask = ::umask(0);
    EXPECT_TRUE(PrivateDirectory::make(folder / "a" / "b" / "c"));
    ::umask(mask);
    for (const char* path : {"a", "a/b", "a/b/c"})
        EXPECT_EQ(mode(folder / path), 0700U);
    EXPECT_EQ(PrivateDirectory::open(folder / "none").error().code, ErrorCode::NotFound);
}

TEST_F(Private, TakesTheRightToReadFromOthers) {
    fs::create_directory(place);
    fs::permissions(place, static_cast<fs::perms>(0755));
    EXPECT_TRUE(PrivateDirectory::open(place));
    EXPECT_EQ(mode(place), 0700U);
}

TEST_F(Private, IsNoneThatOthersMayWriteTo) {
    fs::create_directory(place);
    for (const unsigned bits : {0770U, 0702U, 01777U}) {
        fs::permissions(place, static_cast<fs::perms>(bits));
        expectRefused("is writable by others: expected mode 0700, found ");
        EXPECT_EQ(mode(place), bits);
    }
}

TEST_F(Private, IsNoLinkAndNoFile) {
    fs::create_directory(folder / "elsewhere");
    fs::create_directory_symlink("elsewhere", place);
    expectRefused("is a link, not a directory");
    fs::remove(place);
    test::writeRaw(place, "x");
    expectRefused("is a file, not a directory");
}

TEST_F(Private, BelongsToItsUser) {
    place = "/usr"; // root's
    if (::geteuid() == 0) {
        place = folder / "given away";
        fs::create_directory(place);
        ASSERT_EQ(::chown(place.c_str(), 65534, 65534), 0);
    }
    expectRefused(", not to this one, ");
}

TEST_F(Private, OpensFilesOfItsUserAlone) {
    const auto directory = PrivateDirectory::make(place);
    ASSERT_TRUE(directory);
    test::writeRaw(place / "file", "x");
    fs::create_symlink("file", place / "link");
    fs::create_directory(place / "folder");
    ASSERT_EQ(::mkfifo((place / "pipe").c_str(), 0600), 0);
    EXPECT_TRUE(directory->openFile("file").valid());
    for (const char* name : {"link", "folder", "pipe", "none"})
        EXPECT_FALSE(directory->openFile(name).valid()) << name;
}

TEST_F(Private, StaysWhatItWasWhenItsNameLeadsElsewhere) {
    const auto directory = PrivateDirectory::make(place);
    ASSERT_TRUE(directory);
    test::writeRaw(place / "file", "x");
    fs::rename(place, folder / "moved");
    fs::create_directory(folder / "trap");
    fs::create_directory_symlink("trap", place);
    EXPECT_TRUE(directory->openFile("file").valid());
}

} // namespace
} // namespace texplorer::private_directory_test
