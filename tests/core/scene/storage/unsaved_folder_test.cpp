// Drafts are held by locks (flock), which belong to an open file, not to a process: two objects in one
// process exclude each other like two processes. A child process tests that a lock ends with its process.

#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/storage/unsaved_folder.h"

#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace texplorer::unsaved_folder_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class UnsavedFolder : public testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> all;
        if (fs::exists(folder))
            for (const fs::directory_entry& each : fs::directory_iterator(folder))
                all.push_back(each.path().filename().string());
        return all;
    }
    static UnsavedScene draftOf(float shininess) {
        UnsavedScene draft{{}, {}, defaultScene()};
        draft.scene.material.shininess = shininess;
        return draft;
    }
    test::TempDir parent;
    fs::path folder = parent / "state" / "unsaved";
};

TEST_F(UnsavedFolder, IsTheUsersAlone) {
    const mode_t mask = ::umask(0);
    const auto place = UnsavedPlace::create(folder);
    ::umask(mask);
    ASSERT_TRUE(place) << describe(place.error());
    struct stat info = {};
    ASSERT_EQ(::stat(folder.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777, 0700U);
    ASSERT_EQ(::chmod(folder.c_str(), 0755), 0); // created with wrong permissions
    ASSERT_TRUE(UnsavedPlace::create(folder));
    ASSERT_EQ(::stat(folder.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777, 0700U);
}

TEST_F(UnsavedFolder, WindowsAtTheSameTimeHaveDraftsOfTheirOwn) {
    auto one = UnsavedPlace::create(folder);
    auto other = UnsavedPlace::create(folder);
    ASSERT_TRUE(one && other);
    ASSERT_NE(one->draft(), other->draft());
    ASSERT_TRUE(one->write(draftOf(1)));
    ASSERT_TRUE(other->write(draftOf(2)));
    EXPECT_EQ(one->read().value(), draftOf(1));
    EXPECT_EQ(other->read().value(), draftOf(2));
    EXPECT_TRUE(claimOrphans(folder).empty()) << "both windows live";
}

TEST_F(UnsavedFolder, ADraftWithoutItsWindowIsGivenToOneOnly) {
    ASSERT_TRUE(UnsavedPlace::create(folder).value().write(draftOf(1))); // and released
    {
        const std::vector<Orphan> orphans = claimOrphans(folder);
        ASSERT_EQ(orphans.size(), 1U);
        EXPECT_EQ(orphans[0].place->read().value(), draftOf(1));
        EXPECT_TRUE(claimOrphans(folder).empty());
    }
    EXPECT_EQ(claimOrphans(folder).size(), 1U) << "the discarded draft is there again";
    claimOrphans(folder).front().place->remove();
    EXPECT_TRUE(claimOrphans(folder).empty());
    EXPECT_THAT(names(), testing::IsEmpty()) << "no lock stays without its draft";
}

TEST_F(UnsavedFolder, ADraftOfAKilledProcessIsAnOrphan) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const auto place = UnsavedPlace::create(folder);
        const char done = place && place->write(draftOf(3)) ? 'y' : 'n';
        (void)!::write(ready[1], &done, 1);
        for (;;)
            ::pause();
    }
    char done = 0;
    ASSERT_EQ(::read(ready[0], &done, 1), 1);
    EXPECT_EQ(done, 'y');
    EXPECT_TRUE(claimOrphans(folder).empty());
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    const std::vector<Orphan> orphans = claimOrphans(folder);
    ASSERT_EQ(orphans.size(), 1U);
    EXPECT_EQ(orphans[0].place->read().value(), draftOf(3));
    // The same number again: a new process does not overwrite the draft of the old one.
    const auto mine = UnsavedPlace::create(folder);
    ASSERT_TRUE(mine);
    EXPECT_NE(mine->draft(), orphans[0].place->draft());
}

TEST_F(UnsavedFolder, TheYoungestComesFirst) {
    for (int i = 0; i < 3; ++i) {
        UnsavedPlace place = UnsavedPlace::create(folder).value();
        ASSERT_TRUE(place.write(draftOf(static_cast<float>(i))));
        fs::last_write_time(place.draft(), fs::file_time_type::clock::now() + std::chrono::hours(i % 2));
    }
    const std::vector<Orphan> orphans = claimOrphans(folder);
    ASSERT_EQ(orphans.size(), 3U);
    EXPECT_EQ(orphans[0].place->read().value(), draftOf(1));
}

TEST_F(UnsavedFolder, SweepsLocksAndTakesNothingElse) {
    ASSERT_TRUE(UnsavedPlace::create(folder).value().write(draftOf(1)));
    std::ofstream(folder / "17-0.lock").put('\n'); // killed before its first draft
    std::ofstream(folder / "notes.txt") << "mine";
    fs::create_directory(folder / "18-0.scene");
    fs::create_symlink(folder / "notes.txt", folder / "19-0.scene");
    fs::create_symlink(folder / "notes.txt", folder / "20-0.lock");
    EXPECT_EQ(claimOrphans(folder).size(), 1U);
    EXPECT_THAT(names(), testing::IsSupersetOf({"notes.txt", "18-0.scene", "19-0.scene", "20-0.lock"}));
    EXPECT_THAT(names(), testing::Not(testing::Contains("17-0.lock")));
}

TEST_F(UnsavedFolder, ADraftWhoseLockCannotBeOpenedIsReported) {
    fs::path lock;
    {
        const UnsavedPlace place = UnsavedPlace::create(folder).value();
        ASSERT_TRUE(place.write(draftOf(1)));
        lock = fs::path(place.draft()).replace_extension(".lock");
    }
    fs::remove(lock);
    fs::create_symlink(parent / "nowhere", lock);
    const std::vector<Orphan> orphans = claimOrphans(folder);
    ASSERT_EQ(orphans.size(), 1U);
    ASSERT_FALSE(orphans[0].place);
    EXPECT_EQ(orphans[0].place.error().where, lock.string());
    EXPECT_THAT(orphans[0].place.error().message, HasSubstr("can't be locked: "));
}

TEST_F(UnsavedFolder, ADamagedDraftIsASentence) {
    const UnsavedPlace place = UnsavedPlace::create(folder).value();
    std::ofstream(place.draft()) << "Texplorer, unsaved scene, version 1\n\n\n{\"textures\": 3}";
    const Result<UnsavedScene> read = place.read();
    ASSERT_FALSE(read);
    EXPECT_THAT(describe(read.error()), HasSubstr(place.draft().string()));
    EXPECT_THAT(describe(read.error()), HasSubstr("/textures"));
}

TEST_F(UnsavedFolder, ThatCantBeMadeIsASentence) {
    std::ofstream(parent / "file") << "x";
    for (const fs::path& impossible : {parent / "file" / "unsaved", parent / "file", fs::path()}) {
        const Result<UnsavedPlace> place = UnsavedPlace::create(impossible);
        ASSERT_FALSE(place) << impossible;
        EXPECT_FALSE(place.error().message.empty());
        EXPECT_TRUE(claimOrphans(impossible).empty());
    }
    fs::create_directory_symlink(parent.path(), parent / "link");
    EXPECT_FALSE(UnsavedPlace::create(parent / "link")) << "a link may lead into another user's folder";
}

} // namespace
} // namespace texplorer::unsaved_folder_test
