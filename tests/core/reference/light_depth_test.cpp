// What the light sees of squares whose distance is known.

#include "texplorer/image/depth_pixels.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/light_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

namespace texplorer::reference::light_depth_test {
namespace {

/// The camera at the origin looks along -z, and the light with it, at a square 5 in front of both.
Scene squareBeforeTheLight() {
    Scene scene;
    scene.view.distance = 5;
    scene.light.position = {0, 0, 0, 1};
    scene.light.projector = {{0, 0, -5}, 90, 1, 9};
    Model square;
    square.shape = Shape::Quad; // from -1 to 1
    scene.models = {square};
    scene.textures.resize(1);
    scene.textures[0].source = SourceKind::LightDepth;
    scene.textures[0].depthSize = 20;
    scene.textures[0].internalFormat = InternalFormat::DepthComponent24;
    scene.textures[0].minFilter = MinFilter::Nearest;
    scene.passes[0].units[0].enabled = true;
    return scene;
}

double depthOf(const Image& image, int x, int y) {
    return depthAt(image.at(x, y).data()) / double{farthestDepth32};
}

constexpr double step = 1.0 / (1 << 24);

// Section 2.11 with gluPerspective's matrix: depth = (f / (f - n)) (1 - n / d), and gluOrtho's: (d - n) / (f
// - n).
TEST(LightDepth, IsTheWindowDepthOfTheNearestSurface) {
    const Scene scene = squareBeforeTheLight();
    const Image seen = drawLightDepths(scene, 0, 20);
    EXPECT_EQ(seen.format, PixelFormat::Depth32);
    EXPECT_NEAR(depthOf(seen, 10, 10), 9.0 / 8 * (1 - 1.0 / 5), step);
    // 90 degrees show -5 to 5 at that distance, half a unit a texel: the square has 4 of 20 each way.
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(depthOf(seen, i, 10) < 1, i >= 8 && i < 12) << i;
    EXPECT_EQ(depthAt(seen.at(0, 0).data()), farthestDepth32);
}

TEST(LightDepth, IsLinearForALightThatIsADirection) {
    Scene scene = squareBeforeTheLight();
    scene.light.position = {0, 0, 1, 0};
    const Image seen = drawLightDepths(scene, 0, 20);
    EXPECT_NEAR(depthOf(seen, 10, 10), 0.5, step) << "the target lies half way between near and far";
}

TEST(LightDepth, SeesWhatIsAttachedToTheEyeAndNotWhatIsNotDrawn) {
    Scene scene = squareBeforeTheLight();
    scene.models.push_back(scene.models[0]);
    scene.models[1].attachment = Attachment::Eye;
    scene.models[1].position = {0, 0, -2};
    EXPECT_NEAR(depthOf(drawLightDepths(scene, 0, 20), 10, 10), 9.0 / 8 * (1 - 1.0 / 2), step)
        << "the nearer one";
    scene.models[1].visible = false;
    EXPECT_NEAR(depthOf(drawLightDepths(scene, 0, 20), 10, 10), 9.0 / 8 * (1 - 1.0 / 5), step);
    scene.passes[0].enabled = false;
    EXPECT_EQ(depthOf(drawLightDepths(scene, 0, 20), 10, 10), 1);
}

TEST(LightDepths, AreMadeOnceAndOnlyForUnitsThatShowThem) {
    Scene scene = squareBeforeTheLight();
    LightDepths depths;
    const auto seen = [&](double time) { return depths.addedTo({}, scene, time).find(scene.textures[0]); };
    const auto first = seen(0);
    EXPECT_EQ(seen(0), first);
    EXPECT_EQ(seen(7), first) << "nothing moves";
    EXPECT_NE(first, ImageSource().find(scene.textures[0]));
    scene.models[0].spin = {0, 90, 0};
    EXPECT_EQ(seen(0)->surfaces, first->surfaces);
    const auto turned = seen(1);
    EXPECT_NE(turned->surfaces, first->surfaces);
    scene.light.position.x = 1;
    EXPECT_NE(seen(1), turned);
    scene.passes[0].units[0].enabled = false;
    EXPECT_FALSE(showsLightDepths(scene));
    EXPECT_EQ(seen(1), ImageSource().find(scene.textures[0])) << "all is farthest";
}

TEST(LightDepths, LeaveWhatSomebodyElseHasPut) {
    const Scene scene = squareBeforeTheLight();
    ImageSource images;
    const auto own = drawnImage(Image::uninitialised(PixelFormat::Depth32, 20, 20));
    images.putLightDepth(20, own);
    EXPECT_EQ(LightDepths().addedTo(images, scene, 0).find(scene.textures[0]), own);
}

TEST(LightDepths, AreNotKeptUnfinished) {
    const Scene scene = squareBeforeTheLight();
    LightDepths depths;
    std::stop_source stop;
    stop.request_stop();
    const auto nothing = ImageSource().find(scene.textures[0]);
    EXPECT_EQ(depths.addedTo({}, scene, 0, stop.get_token()).find(scene.textures[0]), nothing);
    EXPECT_NE(depths.addedTo({}, scene, 0).find(scene.textures[0])->surfaces, nothing->surfaces);
    EXPECT_EQ(depthOf(drawLightDepths(scene, 0, 20, stop.get_token()), 10, 10), 1);
}

// The square is compared with itself, and with what lies before it.
TEST(LightDepths, CastShadowsInThePicture) {
    Scene scene = squareBeforeTheLight();
    Unit& unit = scene.passes[0].units[0];
    unit.envMode = EnvMode::Replace;
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -0.005F}}, {.op = MatrixOp::Projector}};
    int axis = 0;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ}) {
        each->enabled = true;
        each->eyePlane = glm::vec4(0);
        each->eyePlane[axis++] = 1;
    }
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].compareMode = CompareMode::RToTexture;
    const auto middle = [&] {
        const Result<Frame> frame = drawReference({scene, {}, 0, 9, 9});
        EXPECT_TRUE(frame && frame->problems.empty());
        return std::to_integer<int>(frame->image.at(4, 4)[0]);
    };
    EXPECT_EQ(middle(), 255) << "in the light";
    scene.light.position = {3, 0, 0, 1}; // it hides the square, and the eye sees past it
    scene.models.push_back(scene.models[0]);
    scene.models[1].attachment = Attachment::Eye;
    scene.models[1].position = {1.5F, 0, -2.5F};
    scene.models[1].size = 0.4F;
    EXPECT_EQ(middle(), 0) << "in the shadow";
    for (const bool literal : {false, true}) {
        const Result<Frame> frame = drawReference({scene, {}, 0, 33, 17}, {.literal = literal});
        const Result<Frame> other = drawReference({scene, {}, 0, 33, 17});
        EXPECT_EQ(frame->image, other->image);
    }
}

} // namespace
} // namespace texplorer::reference::light_depth_test
