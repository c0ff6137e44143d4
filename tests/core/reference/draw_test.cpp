// Pictures that can be worked out by hand. Against OpenGL: tests/render/reference_test.cpp.

#include "texplorer/mesh/mesh.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <limits>

namespace texplorer::reference::draw_test {
namespace {

using Pixel = std::array<int, 4>;

Pixel pixelAt(const Image& image, int x, int y) {
    Pixel pixel{};
    for (std::size_t i = 0; i < 4; ++i)
        pixel[i] = std::to_integer<int>(image.at(x, y)[i]);
    return pixel;
}

/// A square that fills the picture exactly, without perspective.
Scene squareScene() {
    Scene scene;
    scene.view.projection = Projection::Orthographic;
    scene.view.fieldOfView = 90;
    scene.view.distance = 1;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Quad;
    scene.material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    return scene;
}

Image drawn(const Scene& scene, int extent, const DrawOptions& options = {},
            const ImageSource& images = ImageSource()) {
    const Result<Frame> result = drawReference({scene, images, 0, extent, extent}, options);
    EXPECT_TRUE(result) << describe(result.error());
    return result ? result->image : Image{};
}

TEST(DrawReference, FillsTheSquareAndNothingElse) {
    Scene scene = squareScene();
    scene.view.background = {0, 1, 0, 1};
    scene.models[0].size = 0.5F;
    const Image image = drawn(scene, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
            EXPECT_EQ(pixelAt(image, x, y), inside ? (Pixel{51, 102, 153, 204}) : (Pixel{0, 255, 0, 255}));
        }
    }
}

// A driver of 1 bit of GL_SUBPIXEL_BITS knows half pixels alone: what begins at 1.6 pixels begins at 1.5
// there, a pixel's centre.
TEST(DrawReference, SnapsCornersAsADriverDoes) {
    Scene scene = squareScene();
    scene.view.background = {0, 1, 0, 1};
    scene.models[0].size = 0.6F; // from 1.6 to 6.4 of 8 pixels
    const auto inside = [&](int cornerBits, bool literal) {
        const Result<Frame> frame = drawReference(
            {.scene = scene, .width = 8, .height = 8, .cornerBits = cornerBits}, {.literal = literal});
        EXPECT_TRUE(frame);
        int count = 0;
        for (int x = 0; x < 8; ++x)
            count += pixelAt(frame->image, x, 4) != Pixel{0, 255, 0, 255} ? 1 : 0;
        return count;
    };
    EXPECT_EQ(inside(0, false), 4);
    EXPECT_EQ(inside(1, false), 5); // 1.5 is a centre, and the left edge owns it
    EXPECT_EQ(inside(1, true), 5);
}

// Section 3.8.10 asks for levels up to GL_TEXTURE_MAX_LEVEL where the filter reads them: without mipmaps the
// base level is drawn, whatever the maximum.
TEST(DrawReference, DrawsTheBaseLevelThoughTheMaximumIsBelowIt) {
    Scene scene = squareScene();
    scene.textures.resize(1);
    Texture& texture = scene.textures[0];
    texture.pattern = Pattern::UvTemplate;
    texture.mipmaps = MipPolicy::Colored;
    texture.minFilter = MinFilter::Nearest;
    texture.baseLevel = 1;
    scene.passes[0].units[0].enabled = true;
    const Image unlimited = drawn(scene, 16);
    EXPECT_NE(pixelAt(unlimited, 8, 8), (Pixel{51, 102, 153, 204})) << "it is textured";
    texture.maxLevel = 0;
    EXPECT_EQ(drawn(scene, 16), unlimited);
    EXPECT_EQ(drawn(scene, 16, {.literal = true}), unlimited);
}

// Both triangles of the square share the diagonal, which runs through pixel centres.
TEST(DrawReference, HitsEveryPixelOfASharedEdgeOnce) {
    Scene scene = squareScene();
    scene.passes[0].blend = true;
    scene.passes[0].blendDst = BlendFactor::One;
    const Image image = drawn(scene, 15);
    for (int y = 0; y < 15; ++y) {
        for (int x = 0; x < 15; ++x)
            EXPECT_EQ(pixelAt(image, x, y), (Pixel{51, 102, 153, 204})) << x << ", " << y;
    }
}

TEST(DrawReference, InterpolatesPerspectiveCorrectlyOrNot) {
    // A line of two texels, dark and light, on a floor that runs from w = 1 to w = 79 or so: seen from above,
    // the middle of the floor is near the horizon, but the middle of its picture is near the viewer.
    Scene scene;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Floor;
    scene.view.distance = 5;
    scene.textures.resize(1);
    Texture& texture = scene.textures[0];
    texture.source = SourceKind::File;
    texture.file = "halves";
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::Nearest;
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    TexCoords coords;
    for (const Vertex& vertex : makeMesh({Shape::Floor}).vertices)
        coords.push_back({0.5F, vertex.position.z > 0 ? 0.0F : 0.99F, 0, 1});
    scene.models[0].texCoords[0] = coords;
    ImageSource images;
    Image halves{PixelFormat::Luminance8, 1, 2, 1, {std::byte{50}, std::byte{200}}};
    images.put("halves", halves);

    const auto light = [&](bool perspective) {
        scene.view.perspectiveHint = perspective ? HintMode::Nicest : HintMode::Fastest;
        const Image image = drawn(scene, 64, {}, images);
        int count = 0;
        for (int y = 0; y < 64; ++y)
            count += pixelAt(image, 32, y)[0] == 200 ? 1 : 0;
        return count;
    };
    EXPECT_LE(light(true), 3);
    EXPECT_GE(light(false), 10);
}

TEST(DrawReference, LeavesOutPassesThatAreOff) {
    Scene scene = defaultScene();
    const Image one = drawn(scene, 64);
    Pass over = scene.passes[0];
    over.depthTest = false;
    over.units = {};
    scene.passes.push_back(over);
    EXPECT_NE(drawn(scene, 64), one);
    scene.passes[1].enabled = false;
    EXPECT_EQ(drawn(scene, 64), one);
    scene.passes[0].enabled = false;
    EXPECT_EQ(pixelAt(drawn(scene, 64), 20, 32), pixelAt(one, 0, 63)) << "the background";
}

TEST(DrawReference, GivesTheSameBytesWithAnyNumberOfThreads) {
    Scene scene = defaultScene();
    scene.passes[0].blend = true;
    scene.passes[0].blendSrc = BlendFactor::SrcAlpha;
    scene.passes[0].blendDst = BlendFactor::OneMinusSrcAlpha;
    scene.passes[0].depthTest = false;
    scene.material.color.a = 0.4F;
    const Image one = drawn(scene, 100, {.threads = 1});
    for (const unsigned threads : {2U, 3U, 8U})
        EXPECT_EQ(drawn(scene, 100, {.threads = threads}), one);
}

Scene sceneFrom(const char* json) {
    const Result<Scene> scene = parseScene(json);
    EXPECT_TRUE(scene) << describe(scene.error());
    return scene ? *scene : Scene();
}

// So many pixels has OpenGL.
TEST(DrawReference, CutsATriangleThatReachesAsFarAsFloatsGo) {
    const Image image =
        drawn(sceneFrom(R"({"version": 1, "models": [{"shape": "mesh", "attachment": "eye", "mesh":
        {"positions": [[1, 0.4, -0.5], [-748, 472, -2e+38], [0.5, -0.35, 0.6]]}}],
        "passes": [{"depthTest": true}]})"),
              64);
    int white = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            white += pixelAt(image, x, y) == Pixel{255, 255, 255, 255} ? 1 : 0;
    }
    EXPECT_EQ(white, 563);
}

// GL_LEQUAL lets all of it pass, which adds the colour twice.
TEST(DrawReference, DrawsATriangleAgainFromAnotherCornerOn) {
    Scene scene =
        sceneFrom(R"({"version": 1, "models": [{"shape": "mesh", "rotation": [-78, 43, 177], "size": 1.26,
        "mesh": {"positions": [[-1.26, 1.02, 0.83], [-1.4, -1.26, 1.48], [1.49, -0.88, -1.31]]}}],
        "material": {"color": [0.2, 0.2, 0.2, 1]}, "passes": [{"depthTest": true, "depthFunc": "GL_LEQUAL",
        "blend": true, "blendSrc": "GL_ONE", "blendDst": "GL_ONE"}]})");
    std::vector<int>& indices = scene.models[0].mesh.indices.edit();
    for (const float position : {0.0F, 2.5F}) { // as a whole; cut by the near plane
        scene.models[0].position.z = position;
        indices = {0, 1, 2, 0, 1, 2};
        const Image expected = drawn(scene, 64);
        for (const std::vector<int>& again :
             {std::vector{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
            std::ranges::copy(again, indices.begin() + 3);
            EXPECT_EQ(drawn(scene, 64).pixels, expected.pixels);
        }
    }
    scene.models[0].mesh.primitive = Primitive::Lines;
    scene.models[0].position.z = 0;
    scene.models[0].lineWidth = 5;
    indices = {0, 1, 0, 1};
    const Image expected = drawn(scene, 64);
    indices = {0, 1, 1, 0};
    // Which pixels are at its ends depends on where it begins (section 3.4.1): a column of five at each.
    const Image turned = drawn(scene, 64);
    int different = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            different += pixelAt(turned, x, y) != pixelAt(expected, x, y) ? 1 : 0;
    }
    EXPECT_LE(different, 10);
}

TEST(ReferenceRenderer, FollowsTheSceneFromPictureToPicture) {
    ReferenceRenderer renderer;
    Scene scene = defaultScene();
    for (const Pattern pattern : {Pattern::Checker, Pattern::Brick, Pattern::Checker}) {
        scene.textures[0].pattern = pattern;
        for (const MinFilter filter : {MinFilter::Nearest, MinFilter::LinearMipmapLinear}) {
            scene.textures[0].minFilter = filter;
            const Result<Frame> next = renderer.draw({scene, {}, 0, 64, 64});
            ASSERT_TRUE(next);
            EXPECT_EQ(next->image, drawn(scene, 64));
        }
    }
}

/// A scene in which a camera, a texture, what it is read from, and a light move.
Scene movingScene() {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "10"},
                           {2, "view.azimuth", "80"},
                           {0, "textures[0].pattern", "checker"},
                           {1, "textures[0].pattern", "brick"},
                           {0, "light.diffuse", "1,1,1,1", Easing::EaseIn},
                           {2, "light.diffuse", "1,0,0,1"}};
    return scene;
}

/// The same by hand.
Scene standingScene(float azimuth, Pattern pattern, glm::vec4 diffuse) {
    Scene scene = defaultScene();
    scene.view.azimuth = azimuth;
    scene.textures[0].pattern = pattern;
    scene.light.diffuse = diffuse;
    return scene;
}

TEST(ReferenceRenderer, DrawsAndExplainsWhatHasKeyFramesAsItStandsThen) {
    ReferenceRenderer renderer;
    const Scene moving = movingScene();
    const std::array<std::pair<double, Scene>, 3> stands{
        {{0, standingScene(10, Pattern::Checker, {1, 1, 1, 1})},
         {1, standingScene(45, Pattern::Brick, {1, 0.75F, 0.75F, 1})},
         {5, standingScene(80, Pattern::Brick, {1, 0, 0, 1})}}};
    for (const auto& [time, scene] : stands) {
        const Result<Frame> drawn = renderer.draw({moving, {}, time, 64, 64});
        const Result<Frame> expected = drawReference({scene, {}, time, 64, 64});
        ASSERT_TRUE(drawn && expected);
        EXPECT_EQ(drawn->image, expected->image) << time;
        const Result<Explanation> explained = renderer.probe({moving, {}, time, 64, 64}, {20, 32});
        const Result<Explanation> other = probe({scene, {}, time, 64, 64}, {20, 32});
        ASSERT_TRUE(explained && other);
        ASSERT_EQ(explained->fragments.size(), other->fragments.size());
        ASSERT_FALSE(explained->fragments.empty());
        EXPECT_EQ(explained->color, other->color) << time;
        EXPECT_EQ(explained->bytes, other->bytes) << time;
    }
}

struct Refused {
    const char* name;
    int width;
    int height;
};
class BadSize : public testing::TestWithParam<Refused> {};
TEST_P(BadSize, IsRefusedWithBothNumbers) {
    const Result<Frame> result = drawReference({defaultScene(), {}, 0, GetParam().width, GetParam().height});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
    EXPECT_THAT(result.error().message, testing::HasSubstr("1 × 1 to 16384 × 16384"));
}
INSTANTIATE_TEST_SUITE_P(All, BadSize,
                         testing::Values(Refused{"Zero", 0, 8}, Refused{"Negative", 8, -1},
                                         Refused{"Huge", 16385, 1}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DrawReference, StopsWhenItIsAskedTo) {
    std::stop_source source;
    source.request_stop();
    const Result<Frame> result = drawReference({defaultScene(), {}, 0, 64, 64}, {.stop = source.get_token()});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

// What is wrong, and the picture that comes of it all the same.
struct Bad {
    const char* name;
    void (*spoil)(Scene& scene);
};
class BadScene : public testing::TestWithParam<Bad> {};

TEST_P(BadScene, IsDrawnWithoutHarm) {
    Scene scene = defaultScene();
    scene.light.colorControl = ColorControl::SeparateSpecular;
    GetParam().spoil(scene);
    EXPECT_EQ(drawn(scene, 48), drawn(scene, 48, {.literal = true}));
    scene.textures[0].maxAnisotropy = 16;
    scene.view.perspectiveHint = HintMode::Fastest;
    const DrawRequest request{scene, {}, 0, 48, 48, AnisotropyMethod::Ellipse};
    const Result<Frame> quick = drawReference(request);
    const Result<Frame> literal = drawReference(request, {.literal = true});
    ASSERT_TRUE(quick && literal);
    EXPECT_EQ(quick->image, literal->image);
}

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void setCoords(Scene& scene, glm::vec4 coord) {
    scene.models[0].texCoords[0] = TexCoords(24, coord);
}
void setScale(Scene& scene, glm::vec3 scale) {
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = scale}};
}

INSTANTIATE_TEST_SUITE_P(
    All, BadScene,
    testing::Values(Bad{"NanCoordinates",
                        [](Scene& it) {
                            setCoords(it, {nan, nan, nan, nan});
                        }},
                    Bad{"InfiniteCoordinates",
                        [](Scene& it) {
                            setCoords(it, {infinity, -infinity, 0, 1});
                        }},
                    Bad{"HugeCoordinates",
                        [](Scene& it) {
                            setCoords(it, {3e38F, -3e38F, 0, 1e-30F});
                        }},
                    Bad{"NoQ",
                        [](Scene& it) {
                            setCoords(it, {1, 1, 0, 0});
                        }},
                    Bad{"QOfEitherSign",
                        [](Scene& it) {
                            setCoords(it, {1, 1, 0, 1});
                            it.models[0].texCoords[0].edit()[0].q = -1;
                        }},
                    Bad{"ZeroScale",
                        [](Scene& it) {
                            setScale(it, {0, 0, 0});
                        }},
                    Bad{"NanScale",
                        [](Scene& it) {
                            setScale(it, {nan, 1, 1});
                        }},
                    Bad{"NoSize", [](Scene& it) { it.models[1].size = 0; }},
                    Bad{"NanSize", [](Scene& it) { it.models[1].size = nan; }},
                    Bad{"HugeModel", [](Scene& it) { it.models[1].size = 1e30F; }},
                    Bad{"EyeInsideTheModel",
                        [](Scene& it) {
                            it.view.distance = 0.5F;
                            it.models[0].position = {0, 0, 0};
                        }},
                    Bad{"EyeInTheTarget", [](Scene& it) { it.view.distance = 0; }},
                    Bad{"NanColor",
                        [](Scene& it) {
                            it.material.color = {nan, infinity, -infinity, nan};
                        }},
                    Bad{"NanBackground", [](Scene& it) { it.view.background = glm::vec4(nan); }},
                    Bad{"NanLight", [](Scene& it) { it.light.position = glm::vec4(nan); }},
                    Bad{"NanShininess", [](Scene& it) { it.material.shininess = nan; }},
                    Bad{"NoFieldOfView", [](Scene& it) { it.view.fieldOfView = 0; }},
                    Bad{"LevelsThatDoNotExist", [](Scene& it) { it.textures[0].baseLevel = 500; }},
                    Bad{"NegativeLevel", [](Scene& it) { it.textures[0].baseLevel = -5; }},
                    Bad{"ContradictingLod",
                        [](Scene& it) {
                            it.textures[0].minLod = 900;
                            it.textures[0].maxLod = -900;
                        }},
                    Bad{"NanLod",
                        [](Scene& it) {
                            it.textures[0].minLod = nan;
                            it.passes[0].units[0].lodBias = nan;
                        }},
                    Bad{"NanAnisotropy", [](Scene& it) { it.textures[0].maxAnisotropy = nan; }},
                    Bad{"ListOfTheWrongLength", [](Scene& it) { it.models[0].texCoords[0].resize(5); }},
                    Bad{"NoPasses", [](Scene& it) { it.passes.clear(); }}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::draw_test
