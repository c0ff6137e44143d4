#include "tests/support/no_threads.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/image_loader.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>

namespace texplorer::image_loader_test {
namespace {

using testing::HasSubstr;
using Wanted = ImageLoader::Wanted;

/// Holds the loading thread at its next progress report, until it is released.
class Gate {
public:
    void close() {
        const std::scoped_lock lock(mutex_);
        open_ = false;
    }
    void open() {
        const std::scoped_lock lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }
    /// Called by the loading thread.
    void pass() {
        std::unique_lock lock(mutex_);
        ++arrivals_;
        changed_.notify_all();
        changed_.wait(lock, [this] { return open_; });
    }
    void awaitArrival() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return arrivals_ > 0; });
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = true;
    int arrivals_ = 0;
};

class Loading : public testing::Test {
protected:
    ~Loading() override { gate.open(); }

    std::filesystem::path bmp(const std::string& name, const std::string& bgr) {
        test::writeRaw(folder / name, test::onePixelBmp(bgr));
        return folder / name;
    }
    static int redOf(const ImageLoader::Content& content) {
        return std::to_integer<int>(
            uprightImage(*std::get<std::shared_ptr<const TextureImage>>(content)).pixels[0]);
    }
    static int redOf(const ImageLoader::Loaded& loaded) { return redOf(loaded.content.value()); }

    test::TempDir folder;
    Gate gate;
    ImageLoader loader{[this] { gate.pass(); }};
};

TEST_F(Loading, GivesPicturesInTheOrderInWhichTheyWereAskedFor) {
    const auto first = loader.load(bmp("a.bmp", {0, 0, 10}));
    const auto second = loader.load(bmp("b.bmp", {0, 0, 20}));
    const auto third = loader.load(folder / "a.bmp"); // twice
    loader.wait();
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 3U);
    EXPECT_EQ(loaded[0].ticket, first);
    EXPECT_EQ(loaded[1].ticket, second);
    EXPECT_EQ(loaded[2].ticket, third);
    EXPECT_NE(first, third);
    EXPECT_EQ(redOf(loaded[0]), 10);
    EXPECT_EQ(redOf(loaded[1]), 20);
    EXPECT_EQ(redOf(loaded[2]), 10);
    EXPECT_EQ(loaded[1].path, folder / "b.bmp");
    EXPECT_TRUE(loader.take().empty());
    EXPECT_FALSE(loader.progress().has_value());
}

TEST_F(Loading, TheSameFileIsReadAgain) {
    (void)loader.load(bmp("a.bmp", {0, 0, 10}));
    loader.wait();
    (void)loader.load(bmp("a.bmp", {0, 0, 99}));
    loader.wait();
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 2U);
    EXPECT_EQ(redOf(loaded[1]), 99);
}

struct Bad {
    const char* name;
    const char* content; // nullptr: there is no such file
    ErrorCode code;
};

class LoadingFails : public Loading, public testing::WithParamInterface<Bad> {};

TEST_P(LoadingFails, WithASentenceAndTheNextOneIsLoaded) {
    if (GetParam().content)
        test::writeRaw(folder / "bad.bmp", std::string(GetParam().content));
    (void)loader.load(folder / "bad.bmp");
    (void)loader.load(bmp("good.bmp", {0, 0, 7}));
    loader.wait();
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 2U);
    ASSERT_FALSE(loaded[0].content.has_value());
    EXPECT_EQ(loaded[0].content.error().code, GetParam().code);
    EXPECT_EQ(loaded[0].content.error().where, (folder / "bad.bmp").string());
    EXPECT_EQ(redOf(loaded[1]), 7);
}

INSTANTIATE_TEST_SUITE_P(All, LoadingFails,
                         testing::Values(Bad{"Missing", nullptr, ErrorCode::NotFound},
                                         Bad{"Empty", "", ErrorCode::Malformed},
                                         Bad{"Text", "Hello, world!", ErrorCode::Unsupported},
                                         Bad{"Half", "BM", ErrorCode::Malformed}),
                         [](const auto& test) { return test.param.name; });

TEST_F(Loading, SaysWhatItIsDoing) {
    gate.close();
    const auto ticket = loader.load(bmp("a.bmp", {0, 0, 10}));
    gate.awaitArrival();
    const auto progress = loader.progress();
    ASSERT_TRUE(progress.has_value());
    EXPECT_EQ(progress->ticket, ticket);
    EXPECT_EQ(progress->path, folder / "a.bmp");
    EXPECT_EQ(progress->step, ImageLoader::Step::Reading);
    EXPECT_EQ(progress->fileBytes, 58U);
    gate.open();
    loader.wait();
    EXPECT_FALSE(loader.progress().has_value());
}

TEST_F(Loading, NothingComesOfWhatIsCancelled) {
    gate.close();
    const auto working = loader.load(bmp("a.bmp", {0, 0, 10}));
    const auto waiting = loader.load(bmp("b.bmp", {0, 0, 20}));
    const auto wanted = loader.load(bmp("c.bmp", {0, 0, 30}));
    gate.awaitArrival();
    loader.cancel(working);
    EXPECT_EQ(loader.progress()->ticket, waiting) << "at once, although the thread is still busy";
    loader.cancel(waiting);
    loader.cancel(12345); // an unknown number
    gate.open();
    loader.wait();
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 1U);
    EXPECT_EQ(loaded[0].ticket, wanted);
    loader.cancel(wanted); // too late: it was taken
}

TEST_F(Loading, WhatIsDoneCanBeCancelledUntilItIsTaken) {
    const auto ticket = loader.load(bmp("a.bmp", {0, 0, 10}));
    loader.wait();
    loader.cancel(ticket);
    EXPECT_TRUE(loader.take().empty());
}

TEST_F(Loading, EndsWithoutACrashWhileMuchIsWaiting) {
    const auto path = bmp("a.bmp", {0, 0, 10});
    ImageLoader other;
    for (int i = 0; i < 100; ++i)
        (void)other.load(path);
}

TEST_F(Loading, ThumbnailsAreSmallPictures) {
    (void)loader.load(bmp("a.bmp", {0, 0, 10}), Wanted::Thumbnail);
    loader.wait();
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 1U);
    const Image& image = std::get<Image>(loaded[0].content.value());
    EXPECT_EQ(image.format, PixelFormat::Rgba8);
    EXPECT_EQ(image.width, 1);
}

TEST_F(Loading, DamagedFilesCanBeLookedInto) {
    test::writeRaw(folder / "half.bmp", test::onePixelBmp({0, 0, 10}).substr(0, 40));
    (void)loader.load(folder / "half.bmp", Wanted::Anatomy);
    loader.wait();
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 1U);
    ASSERT_TRUE(loaded[0].content.has_value());
    const auto file = std::get<std::shared_ptr<const DissectedFile>>(*loaded[0].content);
    EXPECT_EQ(file->fileBytes, 40U);
    EXPECT_EQ(file->bytes.size(), 40U);
    EXPECT_EQ(file->anatomy.format, "BMP");
    EXPECT_FALSE(file->problem.empty());
}

TEST_F(Loading, OfALargeFileTheBeginningIsKept) {
    std::string large = test::onePixelBmp({0, 0, 10});
    large.resize(DissectedFile::keptBytes + 100);
    test::writeRaw(folder / "large.bmp", large);
    const auto content = loadNow(folder / "large.bmp", Wanted::Anatomy);
    ASSERT_TRUE(content.has_value());
    const auto file = std::get<std::shared_ptr<const DissectedFile>>(*content);
    EXPECT_EQ(file->fileBytes, large.size());
    EXPECT_EQ(file->bytes.size(), DissectedFile::keptBytes);
    EXPECT_EQ(file->problem, "");
}

TEST_F(Loading, WithoutAThreadTheFileIsReadAtOnce) {
    const test::NoThreads none;
    const auto ticket = loader.load(bmp("a.bmp", {0, 0, 10}));
    const auto loaded = loader.take();
    ASSERT_EQ(loaded.size(), 1U);
    EXPECT_EQ(loaded[0].ticket, ticket);
    EXPECT_EQ(redOf(loaded[0]), 10);
}

TEST_F(Loading, OnTheSameThreadItIsTheSame) {
    const auto content = loadNow(bmp("a.bmp", {0, 0, 10}), Wanted::Texture);
    ASSERT_TRUE(content.has_value());
    EXPECT_EQ(redOf(*content), 10);
    EXPECT_FALSE(loadNow(folder / "missing.bmp", Wanted::Texture).has_value());
}

} // namespace
} // namespace texplorer::image_loader_test
