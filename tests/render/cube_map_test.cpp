// Cube maps: OpenGL 2.1, section 3.8.6, table 3.19, worked out by hand.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/reference/draw.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace texplorer::cube_map_test {
namespace {

using namespace test;

/// Six faces of 2 x 2 texels in a row. Red tells the face; green is full in the right column, blue in the
/// lower row.
Image strip() {
    Image image = Image::uninitialised(PixelFormat::Rgba8, 12, 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 12; ++x) {
            const auto texel = image.at(x, y);
            texel[0] = static_cast<std::byte>(40 * (x / 2));
            texel[1] = static_cast<std::byte>(x % 2 == 1 ? 255 : 0);
            texel[2] = static_cast<std::byte>(y == 0 ? 255 : 0); // row 0 of an Image is the bottom
            texel[3] = std::byte{255};
        }
    }
    return image;
}

Scene cubeScene() {
    Scene scene = texturedScene();
    scene.passes[0].units[0].target = Target::CubeMap;
    scene.textures[0].wrapS = scene.textures[0].wrapT = Wrap::ClampToEdge;
    return scene;
}

struct Case {
    const char* name;
    glm::vec4 direction;
    int face;
    bool right; ///< s above 1/2
    bool low;   ///< t above 1/2
};
class CubeMap : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(CubeMap, SamplesTheFaceThatADirectionHits) {
    images.put("image", strip());
    Scene scene = cubeScene();
    scene.models[0].texCoords[0] = quadCoords(GetParam().direction);
    const glm::vec4 expected(static_cast<float>(40 * GetParam().face) / 255.0F, GetParam().right ? 1 : 0,
                             GetParam().low ? 1 : 0, 1);
    EXPECT_TRUE(isColor(onlyColor(scene), expected, 0));
    EXPECT_THAT(problems, testing::IsEmpty());
    Result<Frame> ours = reference::drawReference({scene, images, 0, 8, 8});
    ASSERT_TRUE(ours);
    EXPECT_TRUE(isColor(colorAt(ours->image, 4, 4), expected, 0));
}

INSTANTIATE_TEST_SUITE_P(
    All, CubeMap,
    testing::Values(Case{"PositiveX", {2, 1, 0.5F, 1}, 0, false, false}, // sc = -0.5, tc = -1
                    Case{"PositiveXBelow", {2, -1, -0.5F, 1}, 0, true, true},
                    Case{"NegativeX", {-2, 1, 0.5F, 1}, 1, true, false}, // sc = 0.5, tc = -1
                    Case{"NegativeXBelow", {-2, -1, -0.5F, 1}, 1, false, true},
                    Case{"PositiveY", {0.5F, 4, 2, 1}, 2, true, true}, // sc = 0.5, tc = 2
                    Case{"PositiveYBehind", {-0.5F, 4, -2, 1}, 2, false, false},
                    Case{"NegativeY", {0.5F, -4, 2, 1}, 3, true, false}, // sc = 0.5, tc = -2
                    Case{"NegativeYBehind", {-0.5F, -4, -2, 1}, 3, false, true},
                    Case{"PositiveZ", {1, 2, 4, 1}, 4, true, false}, // sc = 1, tc = -2
                    Case{"PositiveZBelow", {-1, -2, 4, 1}, 4, false, true},
                    Case{"NegativeZ", {1, 2, -4, 1}, 5, false, false}, // sc = -1, tc = -2
                    Case{"NegativeZBelow", {-1, -2, -4, 1}, 5, true, true},
                    Case{"OverAQOfTwo", {1, 2, -4, 2}, 5, false, false},
                    Case{"OverANegativeQ", {1, 2, -4, -1}, 4, false, true}),
    [](const auto& test) { return std::string(test.param.name); });

class CubeMaps : public RenderTest {
protected:
    /// The share of pixels in which the reference differs by more than 8 / 255.
    double difference(const Scene& scene, int extent = 160) {
        const Image theirs = picture(scene, extent);
        const Result<Frame> ours = reference::drawReference({scene, images, 0, extent, extent});
        EXPECT_TRUE(ours);
        EXPECT_EQ(ours->problems, problems);
        std::size_t far = 0;
        for (std::size_t i = 0; i < theirs.pixels.size(); i += 4) {
            int worst = 0;
            for (std::size_t c = i; c < i + 4; ++c)
                worst = std::max(worst, std::abs(std::to_integer<int>(theirs.pixels[c]) -
                                                 std::to_integer<int>(ours->image.pixels[c])));
            far += worst > 8 ? 1 : 0;
        }
        return static_cast<double>(far) / static_cast<double>(extent) / static_cast<double>(extent);
    }

    static Scene labelled(TexGenMode mode) {
        Scene scene = defaultScene();
        Texture& texture = scene.textures[0];
        texture.pattern = Pattern::CubeFaces;
        texture.wrapS = texture.wrapT = Wrap::ClampToEdge;
        texture.minFilter = MinFilter::LinearMipmapNearest;
        texture.mipmaps = MipPolicy::Generated;
        scene.models[0].rotation = {20, 30, 0};
        scene.passes[0].lighting = false;
        Unit& unit = scene.passes[0].units[0];
        unit.target = Target::CubeMap;
        for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR}) {
            (unit.*each).enabled = true;
            (unit.*each).mode = mode;
        }
        unit.texGenR.objectPlane = {0, 0, 1, 0};
        return scene;
    }
};

TEST_F(CubeMaps, AreSeenAlikeUnderEveryGenerationOfCoordinates) {
    for (const TexGenMode mode :
         {TexGenMode::ObjectLinear, TexGenMode::NormalMap, TexGenMode::ReflectionMap}) {
        SCOPED_TRACE(rowOf(mode).name);
        EXPECT_LE(difference(labelled(mode)), 0.02);
    }
}

TEST_F(CubeMaps, TurnWithTheTextureMatrix) {
    Scene scene = labelled(TexGenMode::NormalMap);
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Rotate, .amount = {0, 1, 0}, .angle = 70}};
    EXPECT_LE(difference(scene), 0.02);
}

// Two by two texels a face, red 40 times its number.
TEST_F(CubeMaps, GoOnAcrossTheirEdgesWhereTheyAreSeamless) {
    images.put("image", strip());
    Scene scene = cubeScene();
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    const auto colorOf = [&](glm::vec3 direction) {
        scene.models[0].texCoords[0] = quadCoords(glm::vec4(direction, 1));
        const glm::vec4 color = onlyColor(scene);
        EXPECT_THAT(problems, testing::IsEmpty());
        const Result<Frame> ours = reference::drawReference({scene, images, 0, 8, 8});
        EXPECT_TRUE(ours);
        EXPECT_TRUE(isColor(color, colorAt(ours->image, 4, 4), 1));
        return color;
    };
    // Of +x next to +z: red 0 there, 160 here, and half of it between them. Its own texels are clamped.
    EXPECT_NEAR(colorOf({1, 0, 0.9999F}).r * 255, 0, 1);
    scene.passes[0].seamlessCubeMap = true;
    EXPECT_NEAR(colorOf({1, 0, 0.9999F}).r * 255, 80, 1);
    EXPECT_NEAR(colorOf({0.9999F, 0, 1}).r * 255, 80, 1);
    EXPECT_NEAR(colorOf({1, 0, 0}).r * 255, 0, 1) << "the middle of a face is its own";
    // The corner of +x, +y and +z: (0 + 80 + 160) / 3.
    EXPECT_NEAR(colorOf({1, 0.9999F, 0.9998F}).r * 255, 80, 1);
    // The corner of -x, -y and -z: (40 + 120 + 200) / 3.
    EXPECT_NEAR(colorOf({-1, -0.9999F, -0.9998F}).r * 255, 120, 1);
    scene.passes.push_back(scene.passes[0]); // the switch is the pass's own
    scene.passes[1].seamlessCubeMap = false;
    EXPECT_NEAR(colorOf({1, 0, 0.9999F}).r * 255, 0, 1);
    std::swap(scene.passes[0], scene.passes[1]);
    EXPECT_NEAR(colorOf({1, 0, 0.9999F}).r * 255, 80, 1);
}

TEST_F(CubeMaps, AreSeenAlikeWhereTheyAreSeamlessAndSmall) {
    for (const int level : {4, 6, 7}) { // 8 texels along an edge, 2 and 1
        for (const Wrap wrap : {Wrap::ClampToEdge, Wrap::Repeat}) {
            Scene scene = labelled(TexGenMode::NormalMap);
            scene.textures[0].baseLevel = level;
            scene.textures[0].minFilter = MinFilter::Linear;
            scene.textures[0].wrapS = scene.textures[0].wrapT = wrap;
            const Image seams = picture(scene, 96);
            scene.passes[0].seamlessCubeMap = true;
            EXPECT_NE(picture(scene, 96), seams);
            EXPECT_LE(difference(scene), 0.001) << level;
        }
    }
}

TEST_F(CubeMaps, AreDrawnWithSeamsWhereTheDriverHasNoOther) {
    Scene scene = labelled(TexGenMode::NormalMap);
    scene.textures[0].baseLevel = 6;
    const Image seams = picture(scene, 96);
    scene.passes[0].seamlessCubeMap = true;
    view::Capabilities poor = capabilities;
    poor.seamlessCubeMaps = false;
    renderer = makeRenderer(poor).value();
    EXPECT_EQ(picture(scene, 96), seams);
    EXPECT_THAT(problems,
                testing::ElementsAre("passes[0]: the driver has no seamless cube maps; drawn without"));
    scene.passes[0].units[0].target = Target::Texture2D; // where it doesn't matter
    (void)picture(scene, 96);
    EXPECT_THAT(problems, testing::IsEmpty());
}

TEST_F(CubeMaps, TakeAPictureForEachFaceAndTakeItUpright) {
    images.put("image", rgbaImage(1, 2, 1, {{0, 0, 255, 255}, {255, 255, 0, 255}})); // blue below yellow
    Scene scene = cubeScene();
    scene.models[0].texCoords[0] = quadCoords({4, 1, 0, 1});
    // One by two texels are no square: the texture is incomplete, and the white quad shows.
    EXPECT_TRUE(isColor(onlyColor(scene), glm::vec4(1), 0));
    EXPECT_THAT(problems, testing::IsEmpty());
    EXPECT_EQ(difference(scene, 8), 0);

    images.put(
        "image",
        rgbaImage(2, 2, 1, {{0, 0, 255, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}, {255, 255, 0, 255}}));
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 1, 0, 1}, 0));
    scene.models[0].texCoords[0] = quadCoords({0.1F, -1, 4, 1});
    EXPECT_TRUE(isColor(onlyColor(scene), {0, 0, 1, 1}, 0));
}

TEST_F(CubeMaps, TakeCompressedFacesOfAFileAsTheyAre) {
    TextureImage file;
    file.format = "DDS";
    file.faces = 6;
    file.topFirst = true;
    for (int face = 0; face < 6; ++face) {
        BlockImage blocks = BlockImage::uninitialised(BlockFormat::Dxt1, 4, 4);
        // Both colours are 5 bits of red (bits 11 to 15): all texels have the first.
        const auto red = static_cast<std::byte>(face * 5 << 3);
        blocks.blocks = {std::byte{0}, red, std::byte{0}, std::byte{0}, {}, {}, {}, {}};
        file.surfaces.emplace_back(std::move(blocks));
    }
    images.put("image", std::move(file));
    Scene scene = cubeScene();
    const std::array<glm::vec4, 6> directions{
        {{1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}, {0, 0, 1, 1}, {0, 0, -1, 1}}};
    for (int face = 0; face < 6; ++face) {
        scene.models[0].texCoords[0] = quadCoords(directions[static_cast<std::size_t>(face)]);
        EXPECT_TRUE(isColor(onlyColor(scene), {static_cast<float>(face * 5) / 31, 0, 0, 1}, 1)) << face;
        EXPECT_THAT(problems, testing::IsEmpty());
        EXPECT_EQ(difference(scene, 8), 0);
    }
}

TEST_F(CubeMaps, AreCompressedByTheDriverAndReadBackFaceByFace) {
    Scene scene = labelled(TexGenMode::NormalMap);
    scene.textures[0].compression = Compression::Driver;
    EXPECT_FALSE(picture(scene, 16).empty());
    EXPECT_THAT(problems, testing::IsEmpty());
    const auto levels = renderer->readTexture(0, Target::CubeMap);
    ASSERT_TRUE(levels) << describe(levels.error());
    ASSERT_EQ(levels->size(), 6U * 8U);
    for (std::size_t i = 0; i < levels->size(); ++i) {
        EXPECT_EQ((*levels)[i].face, static_cast<int>(i / 8));
        EXPECT_EQ((*levels)[i].number, static_cast<int>(i % 8));
        EXPECT_TRUE(std::holds_alternative<BlockImage>(*(*levels)[i].surface));
    }
}

} // namespace
} // namespace texplorer::cube_map_test
