#include "tests/support/no_threads.h"
#include "texplorer/base/thrown.h"
#include "texplorer/reference/level_map_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace texplorer::reference::level_map_worker_test {
namespace {

LevelMapRequest requestOf(int width, Shown shown = Shown::Lambda) {
    return {{defaultScene(), ImageSource(), 0, width, 48}, {}, shown};
}

TEST(LevelMapWorker, AnswersAtOnceWhereNobodyMustWait) {
    LevelMapWorker worker(LevelMapWorker::When::AtOnce);
    const auto answer = worker.answer(requestOf(64));
    ASSERT_TRUE(answer && answer->map && answer->colors);
    EXPECT_EQ(answer->request, requestOf(64));
    EXPECT_EQ(answer->map->width, 64);
    EXPECT_EQ(*answer->colors, falseColors(*answer->map, Shown::Lambda));
    EXPECT_EQ(worker.answer(requestOf(64)), answer) << "the same question is answered once";
    const auto without = worker.answer(requestOf(64, Shown::Picture));
    ASSERT_TRUE(without && without->map);
    EXPECT_FALSE(without->colors);
}

TEST(LevelMapWorker, AnswersWhatWasAskedLast) {
    std::atomic<int> woken = 0;
    LevelMapWorker worker(LevelMapWorker::When::WhenReady, [&] { ++woken; });
    for (int width = 20; width < 60; ++width)
        (void)worker.answer(requestOf(width));
    worker.wait();
    EXPECT_GE(woken, 1);
    const auto answer = worker.answer(requestOf(59));
    ASSERT_TRUE(answer && answer->map);
    EXPECT_EQ(answer->map->width, 59);
}

TEST(LevelMapWorker, AnswersAtOnceWhereThereIsNoThread) {
    const test::NoThreads none;
    LevelMapWorker worker(LevelMapWorker::When::WhenReady);
    EXPECT_EQ(worker.answer(requestOf(32))->request, requestOf(32));
}

TEST(LevelMapWorker, SaysWhatIsWrong) {
    LevelMapWorker worker(LevelMapWorker::When::AtOnce);
    LevelMapRequest request = requestOf(32);
    request.unit.unit = 3;
    const auto answer = worker.answer(request);
    ASSERT_TRUE(answer);
    ASSERT_FALSE(answer->map);
    EXPECT_FALSE(answer->colors);
    EXPECT_EQ(answer->map.error().message,
              "passes[0].units[3] samples nothing: it is off or its texture can't be drawn");
}

TEST(LevelMapWorker, SaysWhatWasThrown) {
    const LevelWork throwing{{}, [](float) { throw std::runtime_error("the disc is gone"); }, {}};
    for (const auto when : {LevelMapWorker::When::AtOnce, LevelMapWorker::When::WhenReady}) {
        LevelMapWorker worker(when, {}, throwing);
        LevelMapRequest request = requestOf(32);
        request.picture.scene.textures[0].compression = Compression::Cached;
        (void)worker.answer(request);
        worker.wait();
        const auto answer = worker.answer(request);
        ASSERT_TRUE(answer);
        ASSERT_FALSE(answer->map);
        EXPECT_EQ(answer->map.error().message,
                  "the levels of the pixels can't be computed: " + std::string(ownMistake));
    }
}

TEST(LevelMapWorker, GivesTheTexturesBackWhenItRests) {
    for (const auto when : {LevelMapWorker::When::AtOnce, LevelMapWorker::When::WhenReady}) {
        LevelMapWorker worker(when);
        LevelMapRequest request = requestOf(32);
        Texture& texture = request.picture.scene.textures[0];
        texture.source = SourceKind::File;
        texture.file = "grey";
        request.picture.images.put("grey", Image{PixelFormat::Luminance8, 1, 1, 1, {std::byte{128}}});
        const std::weak_ptr<const TextureImage> image = request.picture.images.find(texture);
        (void)worker.answer(request);
        worker.wait();
        request = requestOf(16);
        EXPECT_FALSE(image.expired());
        worker.rest();
        worker.wait();
        EXPECT_TRUE(image.expired());
    }
}

} // namespace
} // namespace texplorer::reference::level_map_worker_test
