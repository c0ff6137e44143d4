// Texture targets: which part of an image they take, and how r chooses in a volume.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

namespace texplorer::target_test {
namespace {

using namespace test;

constexpr Texel red{255, 0, 0, 255};
constexpr Texel green{0, 255, 0, 255};
constexpr Texel blue{0, 0, 255, 255};
constexpr Texel white{255, 255, 255, 255};

glm::vec4 asColor(Texel texel) {
    return glm::vec4(texel[0], texel[1], texel[2], texel[3]) / 255.0F;
}

struct Case {
    const char* name;
    Target target;
    int width;
    int height;
    int depth;
    glm::vec4 coordinate;
    Texel expected;
};

class TextureTarget : public RenderTest, public testing::WithParamInterface<Case> {};

// Four texels, red, green, blue and white, in a row, a column, a square or along the depth.
TEST_P(TextureTarget, Samples) {
    images.put("image",
               rgbaImage(GetParam().width, GetParam().height, GetParam().depth, {red, green, blue, white}));
    Scene scene = texturedScene();
    scene.passes[0].units[0].target = GetParam().target;
    scene.models[0].texCoords[0] = quadCoords(GetParam().coordinate);
    EXPECT_TRUE(isColor(onlyColor(scene), asColor(GetParam().expected), 0));
    EXPECT_THAT(problems, testing::IsEmpty());
}

class UsedTargets : public RenderTest {};

// A picture is as large for each target that it was ever used with.
TEST_F(UsedTargets, AloneAreKept) {
    images.put("image", rgbaImage(2, 2, 1, {red, green, blue, white}));
    Scene scene = texturedScene();
    for (const Target target : {Target::Texture1D, Target::Texture3D, Target::CubeMap}) {
        for (Unit& unit : scene.passes[0].units)
            unit.target = target;
        EXPECT_FALSE(picture(scene, 8).empty());
        for (const EnumRow& row : EnumTable<Target>::rows) {
            const auto each = static_cast<Target>(row.value);
            EXPECT_EQ(renderer->readTexture(0, each).has_value(), each == target)
                << row.name << " after " << rowOf(target).name;
        }
    }
    scene.passes[0].units[0].enabled = false; // to see what the unit does, one switches it off and on
    EXPECT_FALSE(picture(scene, 8).empty());
    EXPECT_TRUE(renderer->readTexture(0, Target::CubeMap));
}

using T = Target;

INSTANTIATE_TEST_SUITE_P(
    All, TextureTarget,
    testing::Values(Case{"Row1D", T::Texture1D, 4, 1, 1, {0.375F, 0.9F, 0.9F, 1}, green},
                    Case{"Column1DTakesTheMiddleRow", T::Texture1D, 1, 4, 1, {0.5F, 0, 0, 1}, blue},
                    Case{"Square1DTakesTheMiddleRow", T::Texture1D, 2, 2, 1, {0.75F, 0, 0, 1}, white},
                    Case{"Square2DLowerLeft", T::Texture2D, 2, 2, 1, {0.25F, 0.25F, 0.9F, 1}, red},
                    Case{"Square2DLowerRight", T::Texture2D, 2, 2, 1, {0.75F, 0.25F, 0.9F, 1}, green},
                    Case{"Square2DUpperLeft", T::Texture2D, 2, 2, 1, {0.25F, 0.75F, 0.9F, 1}, blue},
                    Case{"Volume2DTakesTheMiddleSlice", T::Texture2D, 1, 1, 4, {0.5F, 0.5F, 0, 1}, blue},
                    Case{"Volume3DFirstSlice", T::Texture3D, 1, 1, 4, {0.5F, 0.5F, 0.125F, 1}, red},
                    Case{"Volume3DSecondSlice", T::Texture3D, 1, 1, 4, {0.5F, 0.5F, 0.375F, 1}, green},
                    Case{"Volume3DLastSlice", T::Texture3D, 1, 1, 4, {0.5F, 0.5F, 0.875F, 1}, white},
                    Case{"Picture3DHasOneSlice", T::Texture3D, 2, 2, 1, {0.75F, 0.75F, 0.9F, 1}, white}),
    [](const auto& test) { return std::string(test.param.name); });

class Targets : public RenderTest {};

TEST_F(Targets, PassesCanUseOneUnitWithDifferentTargets) {
    images.put("image", rgbaImage(1, 1, 4, {red, green, blue, white}));
    Scene scene = texturedScene();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[0].units[0].target = Target::Texture3D;
    scene.passes[1].units[0].target = Target::Texture2D; // which 3D would win over if it stayed on
    EXPECT_TRUE(isColor(onlyColor(scene), asColor(blue), 0));
}

TEST_F(Targets, FourUnitsEachAddTheirTexture) {
    Scene scene = texturedScene();
    const std::array<Texel, maxUnits> added{
        {{10, 0, 0, 255}, {0, 20, 0, 255}, {0, 0, 40, 255}, {80, 80, 80, 255}}};
    scene.material.color = {0, 0, 0, 1};
    scene.textures.clear();
    for (std::size_t i = 0; i < added.size(); ++i) {
        const std::string file = "image" + std::to_string(i);
        images.put(file, plainImage(1, 1, added[i]));
        scene.textures.push_back(texturedScene().textures[0]);
        scene.textures.back().file = file;
        Unit& unit = scene.passes[0].units[i];
        unit.enabled = true;
        unit.texture = static_cast<int>(i);
        unit.envMode = EnvMode::Add;
    }
    EXPECT_EQ(onlyColor(scene) * 255.0F, glm::vec4(90, 100, 120, 255));
}

struct FormatCase {
    const char* name;
    PixelFormat format;
    std::array<int, 4> bytes; // as many as the format has
    Texel expected;           // section 3.6.4: what is missing is 0, or 1 for alpha
};

class UploadedPixels : public RenderTest, public testing::WithParamInterface<FormatCase> {};

// Three texels a row: rows of 3, 6 and 9 bytes, which an alignment of four would tear apart.
TEST_P(UploadedPixels, ArriveWhole) {
    Image image = Image::uninitialised(GetParam().format, 3, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(
            GetParam().bytes[i % static_cast<std::size_t>(bytesPerPixel(GetParam().format))]);
    images.put("image", std::move(image));
    EXPECT_TRUE(isColor(onlyColor(texturedScene(), 9), asColor(GetParam().expected), 0));
    EXPECT_THAT(problems, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, UploadedPixels,
    testing::Values(FormatCase{"Alpha", PixelFormat::Alpha8, {70}, {0, 0, 0, 70}},
                    FormatCase{"Luminance", PixelFormat::Luminance8, {70}, {70, 70, 70, 255}},
                    FormatCase{"LuminanceAlpha", PixelFormat::LuminanceAlpha8, {70, 140}, {70, 70, 70, 140}},
                    FormatCase{"Rgb", PixelFormat::Rgb8, {70, 140, 210}, {70, 140, 210, 255}},
                    FormatCase{"Rgba", PixelFormat::Rgba8, {70, 140, 210, 30}, {70, 140, 210, 30}}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::target_test
