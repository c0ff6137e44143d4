#include "app/ui/services/file_writing.h"
#include "tests/support/no_threads.h"
#include "tests/support/temp_dir.h"
#include "texplorer/base/thrown.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>

#include <latch>
#include <stdexcept>

namespace texplorer::ui::file_writing_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Bytes bytesOf(std::string_view text) {
    const ByteView view = viewBytes(text);
    return {view.begin(), view.end()};
}

FileOrder order(const std::filesystem::path& file, std::string text, std::string remark = {}) {
    return {file, "The thing can't be written: {0}.", 0, [=](const FileMaking&) -> Result<MadeFile> {
                return MadeFile{bytesOf(text), remark};
            }};
}

TEST(FileWriting, WritesAndSaysItOnce) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    writing.write(order(folder / "a.txt", "all of it"));
    std::optional<FileNews> news = writing.takeNews();
    ASSERT_TRUE(news);
    EXPECT_EQ(news->text, "Written: " + (folder / "a.txt").string());
    EXPECT_TRUE(news->isGood);
    EXPECT_FALSE(writing.takeNews());
    EXPECT_EQ(readText(folder / "a.txt").value(), "all of it");
    writing.write(order(folder / "b.txt", "most of it", "One of 2 pictures is missing."));
    news = writing.takeNews();
    EXPECT_EQ(news->text, "Written: " + (folder / "b.txt").string() + ". One of 2 pictures is missing.");
    EXPECT_FALSE(news->isGood);
}

TEST(FileWriting, WhatFailsIsOneSentenceAndTheFileStays) {
    const test::TempDir folder;
    ASSERT_TRUE(writeFileAtomically(folder / "a.txt", viewBytes("before")));
    FileWriting writing(When::AtOnce);
    const auto saidOf = [&](FileOrder asked) {
        writing.write(std::move(asked));
        const std::optional<FileNews> news = writing.takeNews();
        EXPECT_TRUE(news && !news->isGood);
        return news ? news->text : Sentence();
    };
    FileOrder refused = order(folder / "a.txt", "");
    refused.make = [](const FileMaking&) -> Result<MadeFile> {
        return fail(ErrorCode::Unsupported, "it has no words", "textures[0]");
    };
    EXPECT_EQ(saidOf(refused), "The thing can't be written: textures[0]: it has no words.");
    refused.make = [](const FileMaking&) -> Result<MadeFile> { throw std::runtime_error("a reason"); };
    EXPECT_EQ(saidOf(refused),
              "The thing can't be written: it can't be created: " + std::string(ownMistake) + ".");
    refused.make = [](const FileMaking&) -> Result<MadeFile> { throw std::bad_alloc(); };
    EXPECT_EQ(saidOf(refused), "The thing can't be written: not enough memory for it.");
    writing.write(refused);
    writing.write(order(folder / "b.txt", "all of it"));
    EXPECT_EQ(writing.takeNews()->text, "The thing can't be written: not enough memory for it.");
    EXPECT_THAT(saidOf(order(folder / "missing" / "a.txt", "")), HasSubstr("missing"));
    EXPECT_EQ(readText(folder / "a.txt").value(), "before");
}

TEST(FileWriting, WhatAnotherProgramHasWrittenMeanwhileStays) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    FileOrder asked = order(folder / "a.txt", "mine");
    asked.make = [make = asked.make, file = asked.file](const FileMaking& making) {
        EXPECT_TRUE(writeFileAtomically(file, viewBytes("theirs")));
        return make(making);
    };
    writing.write(asked); // there was no such file
    asked.replaces = fingerprintOf(folder / "a.txt");
    writing.write(asked); // there was another one
    EXPECT_EQ(readText(folder / "a.txt").value(), "theirs");
    EXPECT_EQ(readText(folder / "a-2.txt").value(), "mine");
    EXPECT_EQ(readText(folder / "a-3.txt").value(), "mine");
    const std::optional<FileNews> news = writing.takeNews();
    ASSERT_TRUE(news);
    EXPECT_FALSE(news->isGood);
    EXPECT_THAT(news->text, HasSubstr("a-2.txt. Another program has written"));

    FileOrder agreed = order(folder / "a.txt", "mine");
    agreed.replaces = fingerprintOf(folder / "a.txt");
    writing.write(agreed);
    EXPECT_EQ(readText(folder / "a.txt").value(), "mine");
}

TEST(FileWriting, TellsHowFarItIs) {
    const test::TempDir folder;
    std::vector<std::size_t> drawn;
    std::vector<float> shares;
    FileWriting* watched = nullptr;
    FileWriting writing(When::AtOnce, [&] {
        if (const auto progress = watched->progress()) {
            drawn.push_back(progress->picturesDrawn());
            shares.push_back(progress->share);
        }
    });
    watched = &writing;
    FileOrder asked = order(folder / "a.txt", "");
    asked.pictures = 3;
    asked.make = [](const FileMaking& making) -> Result<MadeFile> {
        for (int i = 1; i < 3; ++i)
            making.report(static_cast<float>(i) / 3);
        return MadeFile{};
    };
    writing.write(asked);
    EXPECT_THAT(drawn, ElementsAre(0, 1, 2));
    EXPECT_THAT(shares, ElementsAre(0, testing::FloatEq(1.0F / 3), testing::FloatEq(2.0F / 3)));
    EXPECT_FALSE(writing.progress());
}

TEST(FileWriting, OneAfterTheOther) {
    const test::TempDir folder;
    std::latch goOn(1);
    FileWriting writing(When::WhenReady);
    FileOrder first = order(folder / "a.txt", "");
    first.make = [&](const FileMaking&) -> Result<MadeFile> {
        goOn.wait();
        return MadeFile{bytesOf("first")};
    };
    writing.write(first);
    writing.write(order(folder / "a.txt", "second"));
    ASSERT_TRUE(writing.progress());
    EXPECT_EQ(writing.progress()->file, folder / "a.txt");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    goOn.count_down();
    writing.wait();
    EXPECT_EQ(readText(folder / "a.txt").value(), "second");
}

TEST(FileWriting, IsGivenUpWithoutATrace) {
    const test::TempDir folder;
    const std::filesystem::path file = folder / "a.txt";
    ASSERT_TRUE(writeFileAtomically(file, viewBytes("before")));
    std::latch begun(1);
    std::latch goOn(1);
    bool stopped = false;
    FileWriting writing(When::WhenReady);
    FileOrder held = order(file, "");
    held.make = [&](const FileMaking& making) -> Result<MadeFile> {
        begun.count_down();
        goOn.wait();
        stopped = making.levels.stop.stop_requested();
        return MadeFile{bytesOf("after")};
    };
    writing.write(held);
    writing.write(order(folder / "waits.txt", "too"));
    begun.wait();
    EXPECT_TRUE(writing.progress());
    writing.cancel();
    EXPECT_FALSE(writing.progress());
    goOn.count_down();
    writing.write(order(folder / "next.txt", "next"));
    writing.wait();
    EXPECT_TRUE(stopped);
    EXPECT_THAT(writing.takeNews()->text, HasSubstr("next.txt"));
    EXPECT_EQ(readText(file).value(), "before");
    EXPECT_FALSE(std::filesystem::exists(folder / "waits.txt"));
}

TEST(FileWriting, WorksWithoutAThread) {
    const test::TempDir folder;
    const test::NoThreads none;
    FileWriting writing(When::WhenReady);
    writing.write(order(folder / "a.txt", "at once"));
    EXPECT_EQ(readText(folder / "a.txt").value(), "at once");
}

} // namespace
} // namespace texplorer::ui::file_writing_test
