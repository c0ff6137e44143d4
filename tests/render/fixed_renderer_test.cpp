// The renderer as a whole: the same Scene gives the same picture, regardless of what was drawn before it.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <GL/glew.h>
#include <gmock/gmock.h>

namespace texplorer::fixed_renderer_test {
namespace {

using namespace test;
using testing::IsEmpty;

class FixedRenderer : public RenderTest {};

TEST_F(FixedRenderer, DrawsTheDefaultScene) {
    const Image image = picture(defaultScene(), 200);
    EXPECT_THAT(problems, IsEmpty());
    const glm::vec4 background = defaultScene().view.background;
    EXPECT_TRUE(isColor(colorAt(image, 0, 0), background));
    EXPECT_TRUE(isColor(colorAt(image, 199, 199), background));
    // The cube fills the middle of the left half, the sphere that of the right.
    EXPECT_FALSE(isColor(colorAt(image, 60, 100), background, 8));
    EXPECT_FALSE(isColor(colorAt(image, 140, 100), background, 8));
}

TEST_F(FixedRenderer, TwoDrawingsAreEqualToTheByte) {
    const Image first = picture(defaultScene(), 128, 1.5);
    EXPECT_EQ(picture(defaultScene(), 128, 1.5), first);
    auto another = makeRenderer(capabilities);
    ASSERT_TRUE(another);
    renderer = std::move(*another);
    EXPECT_EQ(picture(defaultScene(), 128, 1.5), first);
}

TEST_F(FixedRenderer, DrawsWhatHasKeyFramesAsItStandsThen) {
    Scene moving = defaultScene();
    moving.timeline.keys = {{0, "view.azimuth", "10"},
                            {2, "view.azimuth", "80"},
                            {0, "textures[0].pattern", "checker"},
                            {1, "textures[0].pattern", "brick"}};
    Scene standing = defaultScene();
    standing.view.azimuth = 45;
    standing.textures[0].pattern = Pattern::Brick;
    const Image then = picture(moving, 64, 1);
    EXPECT_EQ(then, picture(standing, 64, 1));
    standing.view.azimuth = 80;
    EXPECT_EQ(picture(moving, 64, 30), picture(standing, 64, 30));
    EXPECT_EQ(picture(moving, 64, 1), then);
    EXPECT_THAT(problems, IsEmpty());
}

struct EditCase {
    const char* name;
    void (*edit)(Scene& scene);
};

class Edits : public RenderTest, public testing::WithParamInterface<EditCase> {};

// Caches must not be visible: after an edit the picture is that of a new renderer, and undoing the edit gives
// the first picture again.
TEST_P(Edits, ShowAtOnceAndCanBeTakenBack) {
    images.put("image",
               rgbaImage(2, 2, 1, {{255, 0, 0, 255}, {0, 255, 0, 128}, {0, 0, 255, 255}, {90, 60, 30, 0}}));
    images.put("other", rgbaImage(2, 1, 1, {{255, 255, 0, 255}, {0, 255, 255, 128}}));
    Scene scene = texturedScene();
    scene.passes[0].units[0].envMode = EnvMode::Modulate;
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {1.5F, 1.5F, 0.9F, 1});
    scene.textures.push_back(scene.textures[0]);
    scene.textures[1].file = "other";
    Model sphere;
    sphere.shape = Shape::Sphere;
    sphere.size = 0.5F;
    scene.models.push_back(sphere);

    const Image before = picture(scene, 64);
    Scene edited = scene;
    GetParam().edit(edited);
    const Image after = picture(edited, 64);
    EXPECT_NE(after, before);
    EXPECT_EQ(picture(scene, 64), before);

    auto fresh = makeRenderer(capabilities);
    ASSERT_TRUE(fresh);
    renderer = std::move(*fresh);
    EXPECT_EQ(picture(edited, 64), after);
}

INSTANTIATE_TEST_SUITE_P(
    All, Edits,
    testing::Values(EditCase{"File", [](Scene& s) { s.textures[0].file = "other"; }},
                    EditCase{"UnitsTexture", [](Scene& s) { s.passes[0].units[0].texture = 1; }},
                    EditCase{"Pattern", [](Scene& s) { s.textures[0].source = SourceKind::Pattern; }},
                    EditCase{"InternalFormat",
                             [](Scene& s) { s.textures[0].internalFormat = InternalFormat::Luminance; }},
                    EditCase{"MinFilterWithoutMips",
                             [](Scene& s) { s.textures[0].minFilter = MinFilter::LinearMipmapLinear; }},
                    EditCase{"MipPolicy",
                             [](Scene& s) {
                                 s.textures[0].mipmaps = MipPolicy::Colored;
                                 s.textures[0].minFilter = MinFilter::NearestMipmapNearest;
                                 s.passes[0].units[0].lodBias = 8;
                                 s.models[0].texCoords[0] = quadCoords({0, 0, 0, 1}, {40, 40, 0, 1});
                             }},
                    EditCase{"MagFilter", [](Scene& s) { s.textures[0].magFilter = MagFilter::Linear; }},
                    EditCase{"Wrap", [](Scene& s) { s.textures[0].wrapS = Wrap::ClampToEdge; }},
                    EditCase{"Target", [](Scene& s) { s.passes[0].units[0].target = Target::Texture1D; }},
                    EditCase{"TexCoord", [](Scene& s) { s.models[0].texCoords[0].edit()[2].x += 0.25F; }},
                    EditCase{"TexCoordsOfTheMesh", [](Scene& s) { s.models[0].texCoords[0].clear(); }},
                    EditCase{"Shape", [](Scene& s) { s.models[0].shape = Shape::Floor; }},
                    EditCase{"ShapeThatTheListDoesNotFit", [](Scene& s) { s.models[0].shape = Shape::Cube; }},
                    EditCase{"Subdivision", [](Scene& s) { s.models[1].slices = 5; }},
                    EditCase{"ModelRemoved", [](Scene& s) { s.models.erase(s.models.begin()); }},
                    EditCase{"ModelHidden", [](Scene& s) { s.models[1].visible = false; }},
                    EditCase{"TextureOff", [](Scene& s) { s.passes[0].units[0].enabled = false; }},
                    EditCase{"TexturesRemoved", [](Scene& s) { s.textures.clear(); }},
                    EditCase{"MorePasses",
                             [](Scene& s) {
                                 s.passes.push_back(s.passes[0]);
                                 s.passes[1].blend = true;
                                 s.passes[1].blendDst = BlendFactor::One;
                             }},
                    EditCase{"Light", [](Scene& s) { s.passes[0].lighting = true; }},
                    EditCase{"Color",
                             [](Scene& s) {
                                 s.material.color = {1, 0.5F, 0.25F, 1};
                             }},
                    EditCase{"Background",
                             [](Scene& s) {
                                 s.view.background = {0, 0, 1, 1};
                                 s.view.distance = 2;
                             }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(FixedRenderer, NewPixelsOfAFileShowAtOnce) {
    images.put("image", plainImage(1, 1, {255, 0, 0, 255}));
    EXPECT_TRUE(isColor(onlyColor(texturedScene()), {1, 0, 0, 1}));
    images.put("image", plainImage(1, 1, {0, 255, 0, 255}));
    EXPECT_TRUE(isColor(onlyColor(texturedScene()), {0, 1, 0, 1}));
}

TEST_F(FixedRenderer, TheFrameIsATextureOfExactlyThatSize) {
    for (const view::Size size : {view::Size{7, 3}, view::Size{1, 1}, view::Size{100, 37}}) {
        const auto frame = renderer->draw(flatScene(), images, 0, size);
        ASSERT_TRUE(frame) << describe(frame.error());
        EXPECT_EQ(frame->size, size);
        GLint width = 0;
        GLint height = 0;
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(frame->picture));
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
        EXPECT_EQ((view::Size{width, height}), size);
        const auto image = renderer->read();
        ASSERT_TRUE(image);
        EXPECT_EQ((view::Size{image->width, image->height}), size);
    }
}

TEST_F(FixedRenderer, KeepsItsTextureWhileTheSizeStays) {
    const auto first = renderer->draw(flatScene(), images, 0, {8, 8});
    const auto second = renderer->draw(defaultScene(), images, 0, {8, 8});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->picture, second->picture);
}

TEST_F(FixedRenderer, ThePictureIsTheFramesTextureBottomRowFirst) {
    images.put("image", rgbaImage(1, 2, 1, {{255, 0, 0, 255}, {0, 0, 255, 255}}));
    const Image image = picture(texturedScene(), 6);
    EXPECT_TRUE(isColor(colorAt(image, 3, 0), {1, 0, 0, 1}, 0));
    EXPECT_TRUE(isColor(colorAt(image, 3, 5), {0, 0, 1, 1}, 0));
}

TEST_F(FixedRenderer, ReadingBeforeDrawingIsRefused) {
    const auto image = renderer->read();
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().message, "there is no picture to read: nothing has been drawn yet");
}

TEST_F(FixedRenderer, CanBeMoved) {
    render::SceneRenderer moved = std::move(*renderer);
    EXPECT_TRUE(moved.draw(flatScene(), images, 0, {4, 4}));
    renderer = std::move(moved);
    EXPECT_TRUE(isColor(onlyColor(flatScene()), {1, 1, 1, 1}));
}

} // namespace
} // namespace texplorer::fixed_renderer_test
