// A delay of 0 writes at once, a delay of one day never.

#include "tests/support/no_threads.h"
#include "tests/support/temp_dir.h"
#include "texplorer/scene/storage/autosave.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <fstream>
#include <mutex>
#include <thread>

namespace texplorer::autosave_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class Autosaving : public testing::Test {
protected:
    [[nodiscard]] static Scene sceneOf(float shininess) {
        Scene scene = defaultScene();
        scene.material.shininess = shininess;
        return scene;
    }
    /// The number of the only draft in the folder; -1: there is none.
    [[nodiscard]] float written() const {
        if (fs::exists(folder))
            for (const fs::directory_entry& each : fs::directory_iterator(folder)) {
                if (each.path().extension() != ".scene")
                    continue;
                std::ifstream file(each.path());
                const std::string text((std::istreambuf_iterator<char>(file)), {});
                return parseUnsaved(text).value().scene.material.shininess;
            }
        return -1;
    }
    void waitUntilWritten(float shininess) const {
        while (written() != shininess)
            std::this_thread::yield();
    }
    test::TempDir parent;
    fs::path folder = parent / "unsaved";
};

TEST_F(Autosaving, WritesOnItsOwn) {
    Autosave autosave(folder, {}, 0ms);
    autosave.keep("/a/b.json", "/a", sceneOf(7));
    waitUntilWritten(7);
    EXPECT_EQ(written(), 7);
    autosave.keep("/a/b.json", "/a", sceneOf(8));
    waitUntilWritten(8);
    EXPECT_EQ(written(), 8);
}

TEST_F(Autosaving, WritesItselfWhereThereIsNoThread) {
    const test::NoThreads none;
    Autosave autosave(folder, {}, 0ms);
    autosave.keep({}, {}, sceneOf(7));
    EXPECT_EQ(written(), 7);
    autosave.forget();
    EXPECT_EQ(written(), -1);
}

/// With a clock that moves only when the test sets it.
TEST_F(Autosaving, SaysWhenItIsDueWhereThereIsNoThread) {
    const test::NoThreads none;
    double now = 100;
    Autosave autosave(folder, {}, 1500ms, [&now] { return now; });
    EXPECT_EQ(autosave.due(), std::nullopt);
    autosave.keep({}, {}, sceneOf(7));
    EXPECT_EQ(autosave.due(), 101.5);
    now = 101;
    autosave.keep({}, {}, sceneOf(8));
    EXPECT_EQ(autosave.due(), 101.5) << "a later edit doesn't put it off";
    EXPECT_EQ(written(), -1);
    now = 101.5;
    autosave.keep({}, {}, sceneOf(8));
    EXPECT_EQ(written(), 8);
    EXPECT_EQ(autosave.due(), std::nullopt);
}

TEST_F(Autosaving, IsNeverDueWhereAThreadWrites) {
    Autosave autosave(folder, {}, 24h);
    autosave.keep({}, {}, sceneOf(7));
    EXPECT_EQ(autosave.due(), std::nullopt);
}

/// On a slow machine too: writing too early is detected, writing late is not an error.
TEST_F(Autosaving, LetsItsDelayPassBeforeItWrites) {
    constexpr auto delay = 100ms;
    Autosave autosave(folder, {}, delay);
    const auto begin = std::chrono::steady_clock::now();
    autosave.keep({}, {}, sceneOf(7));
    waitUntilWritten(7);
    EXPECT_GE(std::chrono::steady_clock::now() - begin, delay);
}

TEST_F(Autosaving, OfTwoSecondsTheUsualDelayLeavesTheDiskAQuarter) {
    EXPECT_LE(Autosave::usualDelay, 1500ms);
}

TEST_F(Autosaving, WaitsForItsDelayAndWritesTheLastOfManyEdits) {
    Autosave autosave(folder, {}, 24h);
    for (int i = 1; i <= 100; ++i)
        autosave.keep({}, {}, sceneOf(static_cast<float>(i)));
    EXPECT_EQ(written(), -1);
    EXPECT_TRUE(autosave.flush());
    EXPECT_EQ(written(), 100);
}

TEST_F(Autosaving, MakesNothingWhereNothingWasEdited) {
    {
        Autosave autosave(folder, {}, 0ms);
        autosave.forget();
        EXPECT_TRUE(autosave.flush());
    }
    EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Autosaving, EndsWithoutACrashBeforeItHasBegun) {
    for (int i = 0; i < 200; ++i)
        const Autosave autosave(folder, {}, 24h);
}

TEST_F(Autosaving, WhatIsSavedLeavesNoTrace) {
    {
        Autosave autosave(folder, {}, 24h);
        autosave.keep({}, {}, sceneOf(1));
        ASSERT_TRUE(autosave.flush());
        autosave.forget();
        ASSERT_TRUE(autosave.flush());
        EXPECT_EQ(written(), -1);
        autosave.keep({}, {}, sceneOf(2)); // and edited again
        ASSERT_TRUE(autosave.flush());
        EXPECT_EQ(written(), 2);
        autosave.forget();
        ASSERT_TRUE(autosave.flush());
    }
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Autosaving, WhatIsNotForgottenStaysForTheNextStart) {
    {
        Autosave autosave(folder, {}, 24h);
        autosave.keep("/a/b.json", "/a", sceneOf(4));
        ASSERT_TRUE(autosave.flush());
    }
    const std::vector<Orphan> orphans = claimOrphans(folder);
    ASSERT_EQ(orphans.size(), 1U);
    const UnsavedScene draft = orphans[0].place->read().value();
    EXPECT_EQ(draft.file, "/a/b.json");
    EXPECT_EQ(draft.folder, "/a");
    EXPECT_EQ(draft.scene, sceneOf(4));
}

TEST_F(Autosaving, GoesOnWithADraftThatItAdopts) {
    {
        Autosave before(folder, {}, 24h);
        before.keep({}, {}, sceneOf(5));
        ASSERT_TRUE(before.flush());
    }
    Autosave autosave(folder, {}, 24h);
    autosave.keep({}, {}, sceneOf(1)); // its own draft, which is given up
    ASSERT_TRUE(autosave.flush());
    std::vector<Orphan> orphans = claimOrphans(folder);
    ASSERT_EQ(orphans.size(), 1U);
    const UnsavedScene draft = orphans[0].place->read().value();
    autosave.adopt(*std::move(orphans[0].place), draft);
    EXPECT_EQ(written(), 5);
    EXPECT_TRUE(claimOrphans(folder).empty());
    autosave.keep({}, {}, sceneOf(6));
    ASSERT_TRUE(autosave.flush());
    EXPECT_EQ(written(), 6) << "the same draft";
    autosave.forget();
    ASSERT_TRUE(autosave.flush());
    EXPECT_EQ(written(), -1);
}

TEST_F(Autosaving, SaysOnceWhyItCantAndAgainWhenItCouldMeanwhile) {
    std::ofstream(parent / "file") << "x";
    std::mutex mutex;
    std::condition_variable news;
    int woken = 0;
    Autosave autosave(
        parent / "file" / "unsaved",
        [&] {
            const std::scoped_lock lock(mutex);
            ++woken;
            news.notify_all();
        },
        0ms);
    autosave.keep({}, {}, sceneOf(1));
    {
        std::unique_lock lock(mutex);
        news.wait(lock, [&] { return woken > 0; });
    }
    const std::optional<Error> problem = autosave.takeProblem();
    ASSERT_TRUE(problem);
    EXPECT_THAT(describe(*problem), testing::HasSubstr((parent / "file").string()));
    autosave.keep({}, {}, sceneOf(2));
    EXPECT_FALSE(autosave.flush());
    EXPECT_FALSE(autosave.takeProblem()) << "not with every edit";

    fs::remove(parent / "file"); // as if the user had fixed it
    autosave.keep({}, {}, sceneOf(3));
    EXPECT_TRUE(autosave.flush());
    EXPECT_TRUE(fs::exists(parent / "file" / "unsaved"));
    fs::remove_all(parent / "file");
    std::ofstream(parent / "file") << "x";
    autosave.keep({}, {}, sceneOf(4));
    EXPECT_FALSE(autosave.flush());
    EXPECT_TRUE(autosave.takeProblem());
}

TEST_F(Autosaving, HasNothingToLoseOnceItIsForgotten) {
    std::ofstream(folder) << "x";
    Autosave autosave(folder, {}, 24h);
    autosave.keep({}, {}, sceneOf(1));
    EXPECT_FALSE(autosave.flush());
    autosave.forget();
    EXPECT_TRUE(autosave.flush());
    EXPECT_TRUE(autosave.flush());
}

TEST_F(Autosaving, TriesAgainWhatCouldNotBeWritten) {
    std::ofstream(folder) << "x";
    Autosave autosave(folder, {}, 24h);
    autosave.keep({}, {}, sceneOf(1));
    EXPECT_FALSE(autosave.flush());
    EXPECT_FALSE(autosave.flush());
    fs::remove(folder); // fixed, but nothing was edited since
    EXPECT_TRUE(autosave.flush());
    EXPECT_EQ(written(), 1);
}

} // namespace
} // namespace texplorer::autosave_test
