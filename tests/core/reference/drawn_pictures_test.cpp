// Pictures of passes: which passes they show, in which order, and what a pass sees of an unfinished one.

#include "texplorer/image/image.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/drawn_pictures.h"

#include <gmock/gmock.h>

namespace texplorer::reference::drawn_pictures_test {
namespace {

using testing::ElementsAre;

/// Pass 0 draws a red square of half the height in picture 1; pass 1 draws one of the whole window, with that
/// picture.
Scene redSquareInAPicture() {
    Scene scene;
    scene.view.projection = Projection::Orthographic;
    scene.view.distance = 1;
    scene.view.fieldOfView = 90; // shows -1 to 1
    scene.view.background = {0, 0, 1, 1};
    Model small;
    small.shape = Shape::Quad; // -1 to 1
    small.size = 0.5F;
    small.ownMaterial = true;
    small.material.color = {1, 0, 0, 1};
    Model large;
    large.shape = Shape::Quad;
    scene.models = {small, large};
    Texture texture;
    texture.source = SourceKind::Picture;
    texture.pictureSize = 8;
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::Nearest;
    scene.textures = {texture};
    scene.passes.resize(2);
    scene.passes[0].picture = 1;
    scene.passes[0].models = {0};
    scene.passes[1].models = {1};
    scene.passes[1].units[0].enabled = true;
    scene.passes[1].units[0].envMode = EnvMode::Replace;
    return scene;
}

std::vector<int> colorAt(const Scene& scene, int x, int y, double time = 0, int size = 16) {
    const Result<Frame> frame = drawReference({scene, {}, time, size, size});
    std::vector<int> color;
    for (const std::byte each : frame.value().image.at(x, y))
        color.push_back(std::to_integer<int>(each));
    return color;
}

TEST(DrawnPictures, ShowTheirPassesOverTheBackground) {
    const Scene scene = redSquareInAPicture();
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(colorAt(scene, 3, 8), ElementsAre(0, 0, 255, 255)) << "texel 1 of 8, outside of the square";
    EXPECT_THAT(colorAt(scene, 4, 4), ElementsAre(255, 0, 0, 255)) << "texel 2, its first one";
}

TEST(DrawnPictures, AreSquareWhateverTheWindowIs) {
    const Scene scene = redSquareInAPicture();
    const Result<Frame> frame = drawReference({scene, {}, 0, 32, 16});
    ASSERT_TRUE(frame);
    int red = 0;
    for (int x = 0; x < 32; ++x)
        red += frame->image.at(x, 8)[0] == std::byte{255} ? 1 : 0;
    EXPECT_EQ(red, 8) << "half of the 16 pixels that the large square has";
}

TEST(DrawnPictures, LeaveTheirPassesOutOfTheWindow) {
    Scene scene = redSquareInAPicture();
    scene.passes[1].enabled = false;
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(0, 0, 255, 255));
    scene.passes[0].picture = 0;
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(255, 0, 0, 255));
}

TEST(DrawnPictures, ShowTheBackgroundWithoutPasses) {
    Scene scene = redSquareInAPicture();
    scene.passes[0].picture = 2;
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(0, 0, 255, 255));
}

/// Each frame draws the picture of the frame before and adds 0.25 to the red of what it shows.
Scene brighterWithEachFrame(int frames) {
    Scene scene = redSquareInAPicture();
    scene.view.background = {0, 0, 0, 0};
    scene.models[0].size = 1;
    scene.models[0].material.color = {0.25F, 0, 0, 1};
    scene.textures[0].frames = frames;
    Unit& unit = scene.passes[0].units[0];
    unit.enabled = true;
    unit.envMode = EnvMode::Add;
    return scene;
}

TEST(DrawnPictures, ShowTheFrameBeforeWhereTheyReadThemselves) {
    EXPECT_THAT(colorAt(brighterWithEachFrame(1), 8, 8), ElementsAre(64, 0, 0, 0)) << "after black";
    EXPECT_THAT(colorAt(brighterWithEachFrame(2), 8, 8), ElementsAre(128, 0, 0, 0));
    EXPECT_THAT(colorAt(brighterWithEachFrame(3), 8, 8), ElementsAre(192, 0, 0, 0));
}

// Texture 0 shows picture 1, texture 1 picture 2; the pass of picture 1 reads picture 2, which is drawn
// later.
TEST(DrawnPictures, AreDrawnInTheOrderOfTheirTextures) {
    Scene scene = redSquareInAPicture();
    scene.textures.push_back(scene.textures[0]);
    scene.textures[1].picture = 2;
    scene.models[0].size = 1;
    Pass second = scene.passes[0];
    second.picture = 2;
    scene.passes.push_back(second);
    Unit& unit = scene.passes[0].units[0];
    unit.enabled = true;
    unit.envMode = EnvMode::Replace;
    unit.texture = 1;
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(0, 0, 0, 0)) << "there is no frame before";
    scene.textures[1].frames = 2;
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(255, 0, 0, 255));
    scene.textures[1].frames = 1;
    std::swap(scene.textures[0], scene.textures[1]); // now that of picture 2 is drawn first
    scene.passes[0].units[0].texture = 0;
    scene.passes[1].units[0].texture = 1;
    EXPECT_THAT(colorAt(scene, 8, 8), ElementsAre(255, 0, 0, 255));
}

// The frames are 1/30 s apart, none is before 0 s.
TEST(DrawnPictures, ShowEarlierFramesAtEarlierTimes) {
    Scene scene = brighterWithEachFrame(2);
    scene.timeline.keys = {{0, "models[0].material.color", "0,0,0,1", Easing::Linear},
                           {1.0F / 30, "models[0].material.color", "0.4,0,0,1", Easing::Linear}};
    EXPECT_THAT(colorAt(scene, 8, 8, 1.0 / 30), ElementsAre(102, 0, 0, 0)) << "0, then 0.4";
    EXPECT_THAT(colorAt(scene, 8, 8, 1.0 / 60), ElementsAre(51, 0, 0, 0)) << "0 at 0 s, then 0.2";
    EXPECT_THAT(colorAt(scene, 8, 8, 2.0 / 30), ElementsAre(204, 0, 0, 0)) << "0.4 twice";
}

Result<Image> blue(const Scene&, const ImageSource&, double, int size) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, size, size);
    std::ranges::fill(image.pixels, std::byte{7});
    return image;
}

TEST(DrawnPictures, AreDrawnAgainOnlyIfSomethingChanged) {
    Scene scene = redSquareInAPicture();
    int drawn = 0;
    const DrawPicture draw = [&](const Scene& pictured, const ImageSource& images, double time, int size) {
        ++drawn;
        EXPECT_TRUE(pictured.passes[0].enabled);
        EXPECT_FALSE(pictured.passes[1].enabled);
        EXPECT_EQ(size, 8);
        return blue(pictured, images, time, size);
    };
    DrawnPictures pictures;
    const auto first = pictures.addedTo({}, scene, 0, draw)->find(scene.textures[0]);
    EXPECT_EQ(pictures.addedTo({}, scene, 0, draw)->find(scene.textures[0]), first);
    EXPECT_EQ(drawn, 1);
    EXPECT_EQ(pictures.addedTo({}, scene, 1, draw)->find(scene.textures[0]), first) << "equal pixels";
    EXPECT_EQ(drawn, 2);
    EXPECT_EQ(pictures.addedTo({}, scene, 1, draw, 5)->find(scene.textures[0]), first);
    EXPECT_EQ(drawn, 3);
    scene.passes[1].enabled = false; // nothing shows it
    EXPECT_EQ(pictures.addedTo({}, scene, 1, draw)->pictures().size(), 0U);
    EXPECT_EQ(drawn, 3);
}

TEST(DrawnPictures, AreNotDrawnWhereTheyAreGiven) {
    const Scene scene = redSquareInAPicture();
    ImageSource images;
    const auto given = drawnImage(*blue(scene, {}, 0, 8));
    images.putPicture({1, 8}, given);
    const DrawPicture draw = [](const Scene&, const ImageSource&, double, int) -> Result<Image> {
        return fail(ErrorCode::Unsupported, "drawn");
    };
    EXPECT_EQ(DrawnPictures().addedTo(images, scene, 0, draw)->find(scene.textures[0]), given);
    EXPECT_FALSE(DrawnPictures().addedTo({}, scene, 0, draw));
}

TEST(DrawnPictures, EndAtAStopRequest) {
    std::stop_source stop;
    stop.request_stop();
    const Result<Frame> frame =
        drawReference({redSquareInAPicture(), {}, 0, 16, 16}, {.stop = stop.get_token()});
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::Cancelled);
}

} // namespace
} // namespace texplorer::reference::drawn_pictures_test
