#include "tests/support/no_threads.h"
#include "tests/support/paused_encoding.h"
#include "texplorer/base/thrown.h"
#include "texplorer/reference/probe_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace texplorer::reference::probe_worker_test {
namespace {

using test::PausedEncoding;

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
    EXPECT_GE(woken, 1);
    EXPECT_LE(woken, 40);
    const auto answer = worker.answer(requestAt(39, 24));
    ASSERT_TRUE(answer && answer->explanation && *answer->explanation);
    EXPECT_EQ((*answer->explanation)->pixel, (PixelPlace{39, 24}));
    EXPECT_FALSE(answer->contributions);
}

TEST(ProbeWorker, AnswersAtOnceWhereThereIsNoThread) {
    const test::NoThreads none;
    ProbeWorker worker(ProbeWorker::When::WhenReady);
    EXPECT_EQ(worker.answer(requestAt(20, 24))->request, requestAt(20, 24));
}

TEST(ProbeWorker, SaysWhatIsWrong) {
    ProbeWorker worker(ProbeWorker::When::AtOnce);
    const auto answer = worker.answer(requestAt(64, 0));
    ASSERT_TRUE(answer && answer->explanation);
    ASSERT_FALSE(*answer->explanation);
    EXPECT_EQ(answer->explanation->error().message, "a picture of 64 × 48 has no pixel 64, 0");
}

TEST(ProbeWorker, SaysWhatWasThrown) {
    const LevelWork throwing{{}, [](float) { throw std::runtime_error("the disc is gone"); }, {}};
    for (const auto when : {ProbeWorker::When::AtOnce, ProbeWorker::When::WhenReady}) {
        ProbeWorker worker(when, {}, throwing);
        ProbeRequest request = requestAt(20, 24);
        request.picture.scene.textures[0].compression = Compression::Cached;
        (void)worker.answer(request);
        worker.wait();
        const auto answer = worker.answer(request);
        ASSERT_TRUE(answer && answer->explanation);
        ASSERT_FALSE(*answer->explanation);
        EXPECT_EQ(answer->explanation->error().message,
                  "the pixel can't be explained: " + std::string(ownMistake));
    }
}

TEST(ProbeWorker, GivesTheTexturesBackWhenItRests) {
    for (const auto when : {ProbeWorker::When::AtOnce, ProbeWorker::When::WhenReady}) {
        ProbeWorker worker(when);
        ProbeRequest request = requestAt(20, 24);
        Texture& texture = request.picture.scene.textures[0];
        texture.source = SourceKind::File;
        texture.file = "grey";
        request.picture.images.put("grey", Image{PixelFormat::Luminance8, 1, 1, 1, {std::byte{128}}});
        const std::weak_ptr<const TextureImage> image = request.picture.images.find(texture);
        (void)worker.answer(request);
        worker.wait();
        request = requestAt(0, 0);
        EXPECT_FALSE(image.expired());
        worker.rest();
        worker.wait();
        EXPECT_TRUE(image.expired());
        const auto next = worker.answer(requestAt(20, 24));
        EXPECT_TRUE(!next || next->request == requestAt(20, 24)) << "the answer from before is forgotten";
    }
}

/// What comes while a question waits for its texture's levels, and whether that question is answered all the
/// same.
struct Next {
    const char* name;
    void (*change)(ProbeRequest& request);
    bool bothAreAnswered;
};
class ProbeWorkerWith : public testing::TestWithParam<Next> {};
TEST_P(ProbeWorkerWith, EndsOrFinishesTheLastQuestion) {
    PausedEncoding encoding;
    int answers = 0;
    ProbeWorker worker(
        ProbeWorker::When::WhenReady, [&answers] { ++answers; }, encoding.work());
    ProbeRequest request = requestAt(20, 24);
    request.picture.scene.textures[0].compression = Compression::Cached;
    request.texel = TexelQuestion{};
    (void)worker.answer(request);
    encoding.waitUntilBegun();
    GetParam().change(request);
    (void)worker.answer(request);
    encoding.goOn();
    worker.wait();
    EXPECT_EQ(answers, GetParam().bothAreAnswered ? 2 : 1);
    EXPECT_EQ(worker.answer(request)->request, request);
}
INSTANTIATE_TEST_SUITE_P(
    All, ProbeWorkerWith,
    testing::Values(Next{"OtherLevels",
                         [](ProbeRequest& r) { r.picture.scene.textures[0].mipFilter = MipFilter::Mitchell; },
                         false},
                    Next{"AnotherTexel", [](ProbeRequest& r) { r.texel->texel.index.x = 1; }, false},
                    Next{"NoTexel", [](ProbeRequest& r) { r.texel.reset(); }, false},
                    Next{"AnotherPixel", [](ProbeRequest& r) { r.pixel->x = 21; }, true},
                    Next{"AnotherView", [](ProbeRequest& r) { r.picture.scene.view.azimuth += 1; }, true},
                    Next{"OtherParameters",
                         [](ProbeRequest& r) {
                             r.picture.scene.textures[0].borderColor = {1, 0, 0, 1};
                         },
                         true}),
    [](const auto& test) { return std::string(test.param.name); });

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

TEST(ProbeWorker, EndsWithoutACrashWhileItWorks) {
    Scene scene = defaultScene();
    scene.models[1].slices = scene.models[1].stacks = 256;
    for (int i = 0; i < 8; ++i) {
        ProbeWorker worker(ProbeWorker::When::WhenReady);
        (void)worker.answer({{scene, ImageSource(), 0, 640, 480}, PixelPlace{i, i}, TexelQuestion{}});
    }
}

} // namespace
} // namespace texplorer::reference::probe_worker_test
