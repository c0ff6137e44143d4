#include "core/reference/draw_worker.h"

#include <gmock/gmock.h>

#include <atomic>
#include <limits>

namespace texplorer::reference {
namespace {

using When = DrawWorker::When;

DrawRequest requestOf(Scene scene, int width = 160, int height = 100) {
    return {std::move(scene), ImageSource{}, 0, width, height};
}

Scene turned(float azimuth) {
    Scene scene = defaultScene();
    scene.view.azimuth = azimuth;
    return scene;
}

Image expected(const DrawRequest& request) {
    return drawReference(request.scene, request.images, request.time, request.width, request.height)
        .value()
        .image;
}

/// Asks until the whole picture is there, as a window does that is woken.
DrawWorker::Picture wholePicture(DrawWorker& worker, const DrawRequest& request) {
    static_cast<void>(worker.picture(request));
    worker.wait();
    return worker.picture(request);
}

class DrawWorkerTest : public testing::TestWithParam<When> {};

TEST_P(DrawWorkerTest, GivesWhatTheReferenceDraws) {
    DrawWorker worker(GetParam());
    for (const float azimuth : {0.0F, 40.0F}) {
        const DrawRequest request = requestOf(turned(azimuth));
        const DrawWorker::Picture picture = wholePicture(worker, request);
        ASSERT_TRUE(picture.image);
        EXPECT_TRUE(picture.whole);
        EXPECT_EQ(*picture.image, expected(request));
        EXPECT_EQ(worker.picture(request).image, picture.image) << "the same is not drawn again";
    }
}

TEST_P(DrawWorkerTest, SaysWhatCanNotBeDrawn) {
    DrawWorker worker(GetParam());
    const DrawWorker::Picture picture = wholePicture(worker, requestOf(defaultScene(), 0, 10));
    EXPECT_FALSE(picture.image);
    EXPECT_TRUE(picture.whole);
    EXPECT_THAT(picture.problems, testing::ElementsAre(testing::HasSubstr("not 0 x 10")));
}

TEST_P(DrawWorkerTest, PassesOnWhatTheReferenceSays) {
    Scene scene = defaultScene();
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "nowhere.png";
    DrawWorker worker(GetParam());
    EXPECT_THAT(wholePicture(worker, requestOf(scene)).problems,
                testing::ElementsAre(testing::HasSubstr("nowhere.png")));
}

TEST_P(DrawWorkerTest, ForgetsWhatNobodyLooksAt) {
    DrawWorker worker(GetParam());
    const DrawRequest request = requestOf(turned(10));
    const std::shared_ptr<const Image> before = wholePicture(worker, request).image;
    worker.rest();
    const DrawWorker::Picture again = wholePicture(worker, request);
    ASSERT_TRUE(again.image);
    EXPECT_NE(again.image, before);
    EXPECT_EQ(*again.image, *before);
}

INSTANTIATE_TEST_SUITE_P(Ways, DrawWorkerTest, testing::Values(When::AtOnce, When::WhenReady),
                         [](const auto& test) {
                             return test.param == When::AtOnce ? "AtOnce" : "WhenReady";
                         });

TEST(DrawWorkerThread, TheLastPictureStaysUntilThereIsANewOne) {
    std::atomic<int> wakes = 0;
    DrawWorker worker(When::WhenReady, [&wakes] { ++wakes; });
    EXPECT_FALSE(worker.isDrawing());
    ASSERT_TRUE(wholePicture(worker, requestOf(turned(0))).whole);
    EXPECT_GT(wakes, 0);
    for (int degree = 1; degree <= 50; ++degree) { // a drag, faster than it can be drawn
        const DrawWorker::Picture meanwhile =
            worker.picture(requestOf(turned(static_cast<float>(degree)), 900, 700));
        ASSERT_TRUE(meanwhile.image) << degree;
    }
    const DrawRequest last = requestOf(turned(50), 900, 700);
    const DrawWorker::Picture picture = wholePicture(worker, last);
    EXPECT_TRUE(picture.whole);
    EXPECT_EQ(*picture.image, expected(last));
    EXPECT_FALSE(worker.isDrawing());
}

TEST(DrawWorkerThread, OtherTexturesEndEvenACoarsePicture) {
    DrawWorker worker(When::WhenReady);
    Scene scene = defaultScene();
    DrawRequest request;
    for (const Pattern pattern :
         {Pattern::Checker, Pattern::MipColors, Pattern::Checker, Pattern::MipColors}) {
        scene.textures[0].pattern = pattern;
        request = requestOf(scene, 500, 400);
        static_cast<void>(worker.picture(request));
    }
    worker.wait();
    EXPECT_EQ(*worker.picture(request).image, expected(request));
}

TEST(DrawWorkerThread, EndsWithWorkUnderWay) {
    DrawWorker resting(When::WhenReady);
    static_cast<void>(resting.picture(requestOf(defaultScene(), 4000, 4000)));
    resting.rest();
    resting.wait();
    EXPECT_FALSE(resting.isDrawing());
    DrawWorker destroyed(When::WhenReady);
    static_cast<void>(destroyed.picture(requestOf(defaultScene(), 4000, 4000)));
}

TEST(Coarseness, IsAsFineAsIsQuick) {
    EXPECT_EQ(coarseness(0), 1);
    EXPECT_EQ(coarseness(30), 1);
    EXPECT_EQ(coarseness(31), 2);
    EXPECT_EQ(coarseness(120), 2);
    EXPECT_EQ(coarseness(121), 4);
    EXPECT_EQ(coarseness(481), 8);
    EXPECT_EQ(coarseness(1e9), 8);
    EXPECT_EQ(coarseness(std::numeric_limits<double>::quiet_NaN()), 1);
}

} // namespace
} // namespace texplorer::reference
