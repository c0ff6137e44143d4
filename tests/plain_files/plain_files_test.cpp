// The plain versions of core/files/*_linux.cpp where they promise less.

#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/file_lock.h"
#include "texplorer/files/private_directory.h"

#include <gmock/gmock.h>

#include <cerrno>
#include <set>

namespace texplorer::plain_files_test {
namespace {

namespace fs = std::filesystem;

class PlainFiles : public testing::Test {
protected:
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> found;
        for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder.path()))
            found.insert(each.path().lexically_relative(folder.path()).string());
        return found;
    }
    [[nodiscard]] std::string textIn(const std::string& name) const {
        return readText(folder / name).value_or("unreadable");
    }
    test::TempDir folder;
};

TEST_F(PlainFiles, HaveNoLocks) {
    EXPECT_EQ(lockFile(0), ENOTSUP) << "or these are not the plain versions";
}

TEST_F(PlainFiles, AppearAndAreReplacedAsAWhole) {
    const auto write = [&](std::string_view text) {
        return writeFileAtomically(folder / "a.txt", viewBytes(text), [&] {
            EXPECT_EQ(names().size(), fs::exists(folder / "a.txt") ? 2U : 1U) << "a draft next to it";
        });
    };
    ASSERT_TRUE(write("one"));
    EXPECT_EQ(textIn("a.txt"), "one");
    ASSERT_TRUE(write("another"));
    EXPECT_EQ(textIn("a.txt"), "another");
    EXPECT_THAT(names(), testing::ElementsAre("a.txt")) << "no draft is left";
}

TEST_F(PlainFiles, LeaveTheOldOneWhereTheyCanNotBeWritten) {
    test::writeRaw(folder / "file", std::string("old"));
    EXPECT_FALSE(writeFileAtomically(folder / "file" / "below", viewBytes("new")));
    EXPECT_FALSE(writeFileAtomically(folder / "missing" / "below", viewBytes("new")));
    EXPECT_EQ(textIn("file"), "old");
    EXPECT_THAT(names(), testing::ElementsAre("file"));
}

TEST_F(PlainFiles, OfAFolderAppearTogether) {
    const std::vector<FileContent> files{{"a", viewBytes("1")}, {"b", viewBytes("2")}};
    ASSERT_TRUE(writeFolderAtomically(folder / "new", files));
    EXPECT_THAT(names(), testing::ElementsAre("new", "new/a", "new/b"));
    EXPECT_EQ(textIn("new/b"), "2");
}

TEST_F(PlainFiles, AreNeverTakenForThoseOfAProgramThatDied) {
    test::writeRaw(folder / ".texplorer-1-0.tmp", std::string("another process"));
    ASSERT_TRUE(writeFileAtomically(folder / "a", viewBytes("1")));
    EXPECT_THAT(names(), testing::ElementsAre(".texplorer-1-0.tmp", "a"))
        << "without locks it is unknown whether its writer still runs";
}

TEST_F(PlainFiles, LieInAPrivateDirectory) {
    const Result<PrivateDirectory> made = PrivateDirectory::make(folder / "mine" / "alone");
    ASSERT_TRUE(made) << describe(made.error());
    ASSERT_TRUE(writeFileAtomically(made->descriptor(), "a", viewBytes("1"), "a"));
    EXPECT_EQ(textIn("mine/alone/a"), "1");
}

} // namespace
} // namespace texplorer::plain_files_test
