#include "tests/support/no_threads.h"
#include "texplorer/image/mip_colors.h"
#include "texplorer/texture/levels_worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

namespace texplorer::levels_worker_test {
namespace {

using testing::HasSubstr;

LevelsRequest requestFor(int extent, MipPolicy mipmaps = MipPolicy::Generated) {
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = "some/where/grey.png";
    texture.mipmaps = mipmaps;
    const Image image = Image::uninitialised(PixelFormat::Luminance8, extent, extent);
    return {std::make_shared<const TextureImage>(textureOf(image, {})), imageSettings(texture),
            Target::Texture2D};
}

constexpr int small = 64;
constexpr int large = 1024;

/// Holds the working thread up when it begins.
struct Gate {
    std::mutex mutex;
    std::condition_variable changed;
    bool isOpen = false;

    std::function<void()> wake() {
        return [this] {
            std::unique_lock lock(mutex);
            changed.wait(lock, [this] { return isOpen; });
        };
    }
    void open() {
        const std::scoped_lock lock(mutex);
        isOpen = true;
        changed.notify_all();
    }
};

TEST(LevelsWorker, MakesSmallLevelsWhileOneWaits) {
    LevelsWorker worker(LevelsWorker::When::WhenReady);
    const auto levels = worker.prepare(requestFor(small));
    ASSERT_NE(levels, nullptr);
    ASSERT_TRUE(levels->has_value());
    EXPECT_EQ((*levels)->levels.size(), 7U);
    EXPECT_EQ(worker.progress(), std::nullopt);
}

TEST(LevelsWorker, MakesLargeLevelsLaterAndOnce) {
    LevelsWorker worker(LevelsWorker::When::WhenReady);
    const LevelsRequest request = requestFor(large);
    EXPECT_EQ(worker.prepare(request), nullptr);
    EXPECT_EQ(worker.prepare(request), nullptr);
    worker.wait();
    EXPECT_TRUE(worker.receive());
    const auto levels = worker.prepare(request);
    ASSERT_NE(levels, nullptr);
    EXPECT_EQ((*levels)->levels.size(), 11U);
    EXPECT_FALSE(worker.receive());
}

TEST(LevelsWorker, WithoutAUserMakesEverythingAtOnce) {
    LevelsWorker worker(LevelsWorker::When::AtOnce);
    EXPECT_NE(worker.prepare(requestFor(large)), nullptr);
}

TEST(LevelsWorker, WithoutAThreadTheyAreThereForTheNextFrame) {
    const test::NoThreads none;
    int woken = 0;
    LevelsWorker worker(LevelsWorker::When::WhenReady, [&woken] { ++woken; });
    const LevelsRequest request = requestFor(large);
    EXPECT_EQ(worker.prepare(request), nullptr);
    EXPECT_GT(woken, 0);
    EXPECT_TRUE(worker.receive());
    EXPECT_NE(worker.prepare(request), nullptr);
}

TEST(LevelsWorker, AnErrorIsAnAnswer) {
    LevelsWorker worker(LevelsWorker::When::WhenReady);
    const LevelsRequest empty{std::make_shared<const TextureImage>(), imageSettings(Texture{}),
                              Target::Texture2D};
    const auto levels = worker.prepare(empty);
    ASSERT_NE(levels, nullptr);
    EXPECT_FALSE(levels->has_value());
    EXPECT_THAT(worker.summary(empty)->problem, HasSubstr("empty"));
}

TEST(LevelsWorker, ASummaryHasAPictureOfEachLevel) {
    LevelsWorker worker(LevelsWorker::When::AtOnce);
    const auto summary = worker.summary(requestFor(large, MipPolicy::Colored));
    ASSERT_EQ(summary->levels.size(), 11U);
    for (const auto& [number, picture] : summary->levels) {
        const int extent = std::min(large >> number, LevelsSummary::levelExtent);
        EXPECT_EQ(picture->format, PixelFormat::Rgba8);
        EXPECT_EQ(picture->width, extent) << number;
        EXPECT_EQ(picture->height, extent) << number;
        if (number == 0) // the image's own
            continue;
        const auto color = mipColor(number);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(std::to_integer<int>(picture->at(extent / 2, extent / 2)[i]), color[i]) << number;
    }
}

// What a file has on top stays on top, whichever way its rows are uploaded.
TEST(LevelsWorker, PicturesOfLevelsAreUpright) {
    for (const FlipMode flip : {FlipMode::Blocks, FlipMode::Coordinates, FlipMode::Matrix}) {
        LevelsRequest request = requestFor(small, MipPolicy::None);
        Image image{
            PixelFormat::Luminance8, 1, 2, 1, {std::byte{0}, std::byte{255}}}; // the lower row is black
        TextureImage file = textureOf(std::move(image), {});
        file.fileTopFirst = true;
        request.pictures.base = std::make_shared<const TextureImage>(std::move(file));
        request.settings.flip = flip;
        LevelsWorker worker(LevelsWorker::When::AtOnce);
        const auto summary = worker.summary(request);
        ASSERT_EQ(summary->levels.size(), 1U);
        EXPECT_EQ(summary->levels[0].second->at(0, 0)[0], std::byte{0}) << rowOf(flip).name;
        EXPECT_EQ(summary->levels[0].second->at(0, 1)[0], std::byte{255}) << rowOf(flip).name;
    }
}

TEST(LevelsWorker, ASummaryTellsBytesAndRatio) {
    LevelsWorker worker(LevelsWorker::When::WhenReady);
    const LevelsRequest request = requestFor(small);
    const auto summary = worker.summary(request);
    ASSERT_NE(summary, nullptr);
    EXPECT_EQ(summary->report.bytes, 4 * 5461U) << "4 times 4096 + 1024 + 256 + 64 + 16 + 4 + 1";
    EXPECT_NEAR(summary->report.ratioToBase, 5461.0 / 4096, 1e-9);
    EXPECT_NE(worker.prepare(request), nullptr) << "who asked for the numbers first has not taken the levels";
}

TEST(LevelsWorker, WhatTheDriverWillCompressCountsAsBlocks) {
    LevelsWorker worker(LevelsWorker::When::WhenReady);
    LevelsRequest request = requestFor(small);
    request.settings.compression = Compression::Driver;
    const auto before = worker.summary(request);
    ASSERT_NE(before, nullptr);
    EXPECT_TRUE(before->byDriver);
    EXPECT_EQ(before->compressed, BlockFormat::Dxt1);
    EXPECT_EQ(before->report.bytes, (256U + 64 + 16 + 4 + 1 + 1 + 1) * 8) << "blocks of 64, 32 … 1 texels";
    EXPECT_NEAR(before->report.shareOfRgba8, 343.0 * 8 / (4 * 5461), 1e-9);
    EXPECT_EQ(before->report.levels[0].psnr, std::nullopt);

    // A driver that loses nothing.
    const auto levels = worker.prepare(request);
    ASSERT_NE(levels, nullptr);
    worker.uploaded(request, levels, (*levels)->levels);
    EXPECT_EQ(worker.summary(request)->report.levels[0].psnr, std::numeric_limits<double>::infinity());
}

TEST(LevelsWorker, WhatIsNoLongerAskedForIsGivenUp) {
    Gate gate;
    LevelsWorker worker(LevelsWorker::When::WhenReady, gate.wake());
    const LevelsRequest first = requestFor(large);
    LevelsRequest second = first;
    second.settings.mipFilter = MipFilter::Mitchell;
    EXPECT_EQ(worker.prepare(first), nullptr);
    worker.receive();
    EXPECT_EQ(worker.prepare(second), nullptr); // the frame asks for something else
    worker.receive();
    EXPECT_EQ(worker.prepare(second), nullptr);
    gate.open();
    worker.wait();
    worker.receive();
    EXPECT_NE(worker.prepare(second), nullptr);
    EXPECT_EQ(worker.prepare(first), nullptr) << "it was never made";
}

TEST(LevelsWorker, WhatIsCancelledStaysSoUntilItIsWantedAgain) {
    Gate gate;
    LevelsWorker worker(LevelsWorker::When::WhenReady, gate.wake());
    const LevelsRequest request = requestFor(large);
    EXPECT_EQ(worker.prepare(request), nullptr);
    const auto progress = worker.progress();
    ASSERT_TRUE(progress.has_value());
    EXPECT_EQ(progress->what, "grey.png");
    worker.cancel(progress->ticket);
    EXPECT_EQ(worker.progress(), std::nullopt);
    EXPECT_TRUE(worker.isCancelled(request));
    const auto refused = worker.prepare(request);
    ASSERT_NE(refused, nullptr);
    ASSERT_FALSE(refused->has_value());
    EXPECT_EQ(refused->error().code, ErrorCode::Cancelled);
    gate.open();
    worker.wait();
    worker.receive();
    EXPECT_FALSE(worker.prepare(request)->has_value());

    worker.retry(request);
    EXPECT_EQ(worker.prepare(request), nullptr);
    worker.wait();
    worker.receive();
    EXPECT_TRUE(worker.prepare(request)->has_value());
}

TEST(LevelsWorker, LargeLevelsThatNobodyTakesAreLetGo) {
    LevelsWorker worker(LevelsWorker::When::WhenReady);
    const LevelsRequest request = requestFor(large);
    EXPECT_EQ(worker.summary(request), nullptr);
    worker.wait();
    worker.receive();
    ASSERT_NE(worker.summary(request), nullptr);
    worker.receive();
    worker.receive();
    worker.receive();
    EXPECT_NE(worker.summary(request), nullptr) << "the numbers stay";
    EXPECT_EQ(worker.prepare(request), nullptr) << "the levels are made again";
}

} // namespace
} // namespace texplorer::levels_worker_test
