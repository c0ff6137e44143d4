#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_watch.h"

#include <gmock/gmock.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace texplorer::file_watch_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class FileWatching : public testing::Test {
protected:
    /// What is reported, once something is.
    std::vector<fs::path> nextChange() {
        for (;;) {
            if (std::vector<fs::path> changed = watch.changed(); !changed.empty())
                return changed;
            std::unique_lock lock(mutex);
            if (!woken.wait_for(lock, std::chrono::seconds(30), [this] { return calls > 0; }))
                return {};
            --calls;
        }
    }

    test::TempDir folder;
    std::mutex mutex;
    std::condition_variable woken;
    int calls = 0;
    FileWatch watch{[this] {
        const std::scoped_lock lock(mutex);
        ++calls;
        woken.notify_all();
    }};
};

struct Change {
    const char* name;
    void (*make)(const test::TempDir& folder);
};

class FileChange : public FileWatching, public testing::WithParamInterface<Change> {};

TEST_P(FileChange, IsReported) {
    test::writeRaw(folder / "a.bmp", std::string("old"));
    test::writeRaw(folder / "b.bmp", std::string("other"));
    watch.watch({folder / "a.bmp", folder / "b.bmp"});
    EXPECT_THAT(watch.changed(), IsEmpty());
    GetParam().make(folder);
    EXPECT_THAT(nextChange(), ElementsAre(folder / "a.bmp"));
    EXPECT_THAT(watch.changed(), IsEmpty()) << "once";
}

INSTANTIATE_TEST_SUITE_P(
    All, FileChange,
    testing::Values(
        Change{"Written", [](const auto& f) { test::writeRaw(f / "a.bmp", std::string("newer")); }},
        Change{"SameLength", [](const auto& f) { test::writeRaw(f / "a.bmp", std::string("new")); }},
        Change{"ReplacedByRename", // as editors save
               [](const auto& f) {
                   test::writeRaw(f / "a.tmp", std::string("old"));
                   fs::rename(f / "a.tmp", f / "a.bmp");
               }},
        Change{"RemovedAndMadeAgain",
               [](const auto& f) {
                   fs::remove(f / "a.bmp");
                   test::writeRaw(f / "a.bmp", std::string("again"));
               }},
        Change{"Cut", [](const auto& f) { fs::resize_file(f / "a.bmp", 1); }}),
    [](const auto& test) { return test.param.name; });

TEST_F(FileWatching, FollowsALinkToItsFile) {
    fs::create_directory(folder / "elsewhere");
    test::writeRaw(folder / "elsewhere" / "real.bmp", std::string("old"));
    fs::create_symlink("elsewhere/real.bmp", folder / "link.bmp");
    watch.watch({folder / "link.bmp"});
    test::writeRaw(folder / "elsewhere" / "real.bmp", std::string("changed"));
    EXPECT_THAT(nextChange(), ElementsAre(folder / "link.bmp"));
}

TEST_F(FileWatching, NoticesAFileThatWasNotThere) {
    watch.watch({folder / "late.bmp"});
    test::writeRaw(folder / "late.bmp", std::string("here"));
    EXPECT_THAT(nextChange(), ElementsAre(folder / "late.bmp"));
}

TEST_F(FileWatching, AnotherListForgetsNoFileThatStays) {
    test::writeRaw(folder / "a.bmp", std::string("old"));
    test::writeRaw(folder / "b.bmp", std::string("old"));
    watch.watch({folder / "a.bmp", folder / "b.bmp"});
    watch.watch({folder / "b.bmp", folder / "a.bmp"});
    watch.watch({folder / "b.bmp"});
    test::writeRaw(folder / "a.bmp", std::string("unseen"));
    test::writeRaw(folder / "b.bmp", std::string("seen"));
    EXPECT_THAT(nextChange(), ElementsAre(folder / "b.bmp"));
}

TEST_F(FileWatching, LooksByItselfWhereTheFolderIsMissing) {
    watch.watch({folder / "inner" / "a.bmp"}); // nothing can report about a folder that isn't there
    fs::create_directory(folder / "inner");
    test::writeRaw(folder / "inner" / "a.bmp", std::string("here"));
    EXPECT_THAT(nextChange(), ElementsAre(folder / "inner" / "a.bmp"));
}

} // namespace
} // namespace texplorer::file_watch_test
