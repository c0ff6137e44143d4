#include "tests/support/no_threads.h"
#include "tests/support/paused_encoding.h"
#include "texplorer/base/thrown.h"
#include "texplorer/reference/draw_worker.h"

#include <gmock/gmock.h>

#include <atomic>
#include <limits>
#include <random>
#include <stdexcept>

namespace texplorer::reference::draw_worker_test {
namespace {

using test::PausedEncoding;
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
    return drawReference(request).value().image;
}

/// Asks until the whole picture is there, as a window does that is woken.
DrawWorker::Frame wholePicture(DrawWorker& worker, const DrawRequest& request) {
    static_cast<void>(worker.frame(request));
    worker.wait();
    return worker.frame(request);
}

class DrawWorkerTest : public testing::TestWithParam<When> {};

TEST_P(DrawWorkerTest, GivesWhatTheReferenceDraws) {
    DrawWorker worker(GetParam());
    for (const float azimuth : {0.0F, 40.0F}) {
        const DrawRequest request = requestOf(turned(azimuth));
        const DrawWorker::Frame picture = wholePicture(worker, request);
        ASSERT_TRUE(picture.image);
        EXPECT_TRUE(picture.whole);
        EXPECT_EQ(*picture.image, expected(request));
        EXPECT_EQ(worker.frame(request).image, picture.image) << "the same is not drawn again";
    }
}

TEST_P(DrawWorkerTest, SaysWhatCanNotBeDrawn) {
    DrawWorker worker(GetParam());
    const DrawWorker::Frame picture = wholePicture(worker, requestOf(defaultScene(), 0, 10));
    EXPECT_FALSE(picture.image);
    EXPECT_TRUE(picture.whole);
    EXPECT_THAT(picture.problems, testing::ElementsAre(testing::HasSubstr("not 0 × 10")));
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
    const DrawWorker::Frame again = wholePicture(worker, request);
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
        const DrawWorker::Frame meanwhile =
            worker.frame(requestOf(turned(static_cast<float>(degree)), 900, 700));
        ASSERT_TRUE(meanwhile.image) << degree;
    }
    const DrawRequest last = requestOf(turned(50), 900, 700);
    const DrawWorker::Frame picture = wholePicture(worker, last);
    EXPECT_TRUE(picture.whole);
    EXPECT_EQ(*picture.image, expected(last));
    EXPECT_FALSE(worker.isDrawing());
}

/// Large enough to be drawn coarsely first.
DrawRequest compressedRequest(Pattern pattern = Pattern::Checker) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = pattern;
    scene.textures[0].compression = Compression::Cached;
    return requestOf(std::move(scene), 500, 400);
}

TEST(DrawWorkerThread, OtherTexturesEndEvenACoarsePicture) {
    PausedEncoding encoding;
    DrawWorker worker(When::WhenReady, {}, encoding.work());
    static_cast<void>(worker.frame(compressedRequest(Pattern::Checker)));
    encoding.waitUntilBegun();
    const DrawRequest other = compressedRequest(Pattern::MipColors);
    static_cast<void>(worker.frame(other));
    encoding.goOn();
    worker.wait();
    EXPECT_THAT(encoding.shares, testing::ElementsAre(testing::Lt(1), 1));
    EXPECT_EQ(*worker.frame(other).image, expected(other));
}

// While a user drags a border colour there is something to see.
TEST(DrawWorkerThread, OtherParametersLetACoarsePictureBeFinished) {
    PausedEncoding encoding;
    DrawWorker worker(When::WhenReady, {}, encoding.work());
    DrawRequest request = compressedRequest();
    static_cast<void>(worker.frame(request));
    encoding.waitUntilBegun();
    Texture& texture = request.scene.textures[0];
    texture.borderColor = {1, 0, 0, 1};
    texture.wrapS = Wrap::ClampToBorder;
    texture.maxAnisotropy = 4;
    texture.minLod = 1;
    static_cast<void>(worker.frame(request));
    encoding.goOn();
    worker.wait();
    EXPECT_THAT(encoding.shares, testing::ElementsAre(1)) << "the same levels, made once";
    EXPECT_EQ(*worker.frame(request).image, expected(request));
}

/// Of noise that takes seconds to compress.
DrawRequest slowRequest() {
    DrawRequest request = compressedRequest();
    Texture& texture = request.scene.textures[0];
    texture.source = SourceKind::File;
    texture.file = "noise";
    texture.compressionQuality = EncodeQuality::Best;
    Image noise = Image::uninitialised(PixelFormat::Rgb8, 1024, 1024);
    std::minstd_rand dice;
    for (std::byte& each : noise.pixels)
        each = static_cast<std::byte>(dice() >> 8U);
    request.images.put("noise", std::move(noise));
    return request;
}

TEST(DrawWorkerThread, EndsWithWorkUnderWay) {
    for (const bool rests : {true, false}) {
        PausedEncoding encoding(0);
        {
            DrawWorker worker(When::WhenReady, {}, encoding.work());
            static_cast<void>(worker.frame(slowRequest()));
            encoding.waitUntilBegun();
            encoding.goOn();
            if (rests) {
                worker.rest();
                worker.wait();
                EXPECT_FALSE(worker.isDrawing());
            }
        }
        EXPECT_THAT(encoding.shares, testing::ElementsAre(testing::Lt(1)));
    }
}

TEST_P(DrawWorkerTest, GivesTheTexturesBackWhenItRests) {
    DrawWorker worker(GetParam());
    DrawRequest request = requestOf(defaultScene());
    request.scene.textures[0].source = SourceKind::File;
    request.scene.textures[0].file = "grey";
    request.images.put("grey", Image{PixelFormat::Luminance8, 1, 1, 1, {std::byte{128}}});
    const std::weak_ptr<const TextureImage> image = request.images.find(request.scene.textures[0]);
    static_cast<void>(wholePicture(worker, request));
    request = DrawRequest();
    EXPECT_FALSE(image.expired());
    worker.rest();
    worker.wait();
    EXPECT_TRUE(image.expired());
}

TEST_P(DrawWorkerTest, SaysWhatWasThrown) {
    bool throws = true;
    DrawWorker worker(GetParam(), {}, {{}, [&throws](float) {
                                           if (throws)
                                               throw std::runtime_error("the disc is gone");
                                       }});
    const DrawRequest request = compressedRequest();
    const DrawWorker::Frame picture = wholePicture(worker, request);
    EXPECT_FALSE(picture.image);
    EXPECT_THAT(picture.problems,
                testing::ElementsAre("the picture can't be drawn: " + std::string(ownMistake)));
    throws = false;
    const DrawRequest again = compressedRequest(Pattern::MipColors);
    EXPECT_EQ(*wholePicture(worker, again).image, expected(again));
}

TEST(DrawWorkerThread, WhereThereIsNoneThePictureIsDrawnAtOnce) {
    const test::NoThreads none;
    DrawWorker worker(When::WhenReady);
    const DrawRequest request = requestOf(defaultScene(), 500, 400);
    const DrawWorker::Frame& picture = worker.frame(request);
    EXPECT_TRUE(picture.whole);
    EXPECT_EQ(*picture.image, expected(request));
    worker.rest();
    EXPECT_FALSE(worker.isDrawing());
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
} // namespace texplorer::reference::draw_worker_test
