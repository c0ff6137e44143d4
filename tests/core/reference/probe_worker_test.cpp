#include "core/reference/probe_worker.h"

#include <gtest/gtest.h>

#include <atomic>

namespace texplorer::reference {
namespace {

ProbeRequest requestAt(int x, int y) {
    return {{defaultScene(), ImageSource(), 0, 64, 48}, PixelPlace{x, y}};
}

TEST(ProbeWorker, AnswersAtOnceWhereNobodyMustWait) {
    ProbeWorker worker(ProbeWorker::When::AtOnce);
    ProbeRequest request = requestAt(20, 24);
    request.texel = TexelQuestion{};
    const auto answer = worker.answer(request);
    ASSERT_TRUE(answer && answer->explanation && answer->contributions);
    EXPECT_EQ(answer->request, request);
    EXPECT_EQ((*answer->explanation)->pixel, (PixelPlace{20, 24}));
    EXPECT_EQ((*answer->contributions)->width, 64);
    EXPECT_EQ(worker.answer(request), answer) << "the same question is answered once";
}

TEST(ProbeWorker, AnswersWhatWasAskedLast) {
    std::atomic<int> woken = 0;
    ProbeWorker worker(ProbeWorker::When::WhenReady, [&] { ++woken; });
    for (int x = 0; x < 40; ++x)
        (void)worker.answer(requestAt(x, 24));
    worker.wait();
    const auto answer = worker.answer(requestAt(39, 24));
    ASSERT_TRUE(answer && answer->explanation && *answer->explanation);
    EXPECT_EQ((*answer->explanation)->pixel, (PixelPlace{39, 24}));
    EXPECT_FALSE(answer->contributions);
}

TEST(ProbeWorker, SaysWhatIsWrong) {
    ProbeWorker worker(ProbeWorker::When::AtOnce);
    const auto answer = worker.answer(requestAt(64, 0));
    ASSERT_TRUE(answer && answer->explanation);
    EXPECT_FALSE(*answer->explanation);
}

/// What waits behind the work is not begun any more: this one would take seconds.
TEST(ProbeWorker, EndsWithAQuestionThatWaits) {
    Scene scene = defaultScene();
    std::atomic<int> answers = 0;
    {
        ProbeWorker worker(ProbeWorker::When::WhenReady, [&answers] { ++answers; });
        for (int i = 0; i < 4; ++i)
            (void)worker.answer({{scene, ImageSource(), 0, 4096, 4096}, PixelPlace{i, i}, TexelQuestion{}});
    }
    EXPECT_EQ(answers, 0);
}

TEST(ProbeWorker, EndsWhileItWorks) {
    Scene scene = defaultScene();
    scene.models[1].slices = scene.models[1].stacks = 256;
    for (int i = 0; i < 8; ++i) {
        ProbeWorker worker(ProbeWorker::When::WhenReady);
        (void)worker.answer({{scene, ImageSource(), 0, 640, 480}, PixelPlace{i, i}, TexelQuestion{}});
    }
}

} // namespace
} // namespace texplorer::reference
