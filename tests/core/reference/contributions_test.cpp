#include "texplorer/reference/contributions.h"
#include "texplorer/reference/probe.h"

#include <gmock/gmock.h>

namespace texplorer::reference::contributions_test {
namespace {

using testing::HasSubstr;

/// A square that fills the picture exactly, without perspective, with two texels in a row.
struct Flat {
    Scene scene;
    ImageSource images;

    Flat() {
        scene.view.projection = Projection::Orthographic;
        scene.view.fieldOfView = 90;
        scene.view.distance = 1;
        scene.models.resize(1);
        scene.models[0].shape = Shape::Quad;
        scene.textures.resize(1);
        scene.textures[0].source = SourceKind::File;
        scene.textures[0].file = "two";
        scene.textures[0].minFilter = MinFilter::Linear;
        scene.passes[0].units[0].enabled = true;
        images.put("two", Image{PixelFormat::Luminance8, 2, 1, 1, {std::byte{0}, std::byte{255}}});
    }

    /// Of the lowest row of a picture of 4 x 4.
    [[nodiscard]] std::vector<float> row(const TexelQuestion& question) const {
        const Result<Contributions> found = contributions({scene, images, 0, 4, 4}, question);
        EXPECT_TRUE(found) << describe(found.error());
        return found ? std::vector<float>(found->weights.begin(), found->weights.begin() + 4)
                     : std::vector<float>();
    }
};

using testing::ElementsAre;
using testing::FloatEq;

// The pixels' centres are at u = 1/4, 3/4, 5/4 and 7/4; the texels' at 1/2 and 3/2.
TEST(Contributions, AreTheWeightsOfTheFilter) {
    Flat flat;
    EXPECT_THAT(flat.row({.texel = {0, {0, 0, 0}}}),
                ElementsAre(FloatEq(0.75F), FloatEq(0.75F), FloatEq(0.25F), FloatEq(0.25F)));
    EXPECT_THAT(flat.row({.texel = {0, {1, 0, 0}}}),
                ElementsAre(FloatEq(0.25F), FloatEq(0.25F), FloatEq(0.75F), FloatEq(0.75F)));
    flat.scene.textures[0].magFilter = MagFilter::Nearest;
    EXPECT_THAT(flat.row({.texel = {0, {1, 0, 0}}}), ElementsAre(0, 0, 1, 1));
}

TEST(Contributions, KnowTheBorder) {
    Flat flat;
    flat.scene.textures[0].wrapS = Wrap::ClampToBorder;
    EXPECT_THAT(flat.row({.texel = {0, {-1, 0, 0}}}), ElementsAre(FloatEq(0.25F), 0, 0, 0));
    EXPECT_THAT(flat.row({.texel = {0, {2, 0, 0}}}), ElementsAre(0, 0, 0, FloatEq(0.25F)));
}

// A direction that runs from (1, 0, 1/2) on +x to (1/2, 0, 1) on +z: the last texel of +z has a share in
// pixels that hit +x, and only where the faces are filtered as one.
TEST(Contributions, CrossTheEdgesOfASeamlessCubeMap) {
    Flat flat;
    flat.images.put("two", Image::uninitialised(PixelFormat::Luminance8, 2, 2));
    flat.scene.passes[0].units[0].target = Target::CubeMap;
    flat.scene.textures[0].wrapS = flat.scene.textures[0].wrapT = Wrap::ClampToEdge;
    flat.scene.models[0].texCoords[0] = {{1, 0, 0.5F, 1}, {0.5F, 0, 1, 1}, {0.5F, 0, 1, 1}, {1, 0, 0.5F, 1}};
    const TexelQuestion ofPositiveZ{.texel = {0, {1, 0, 4}}};
    const std::vector<float> clamped = flat.row(ofPositiveZ);
    EXPECT_EQ(clamped[0] + clamped[1], 0);
    EXPECT_GT(std::min(clamped[2], clamped[3]), 0);
    flat.scene.passes[0].seamlessCubeMap = true;
    const std::vector<float> seamless = flat.row(ofPositiveZ);
    // The second pixel's direction is (13/16, 0, 11/16): s = (1 - 11/13) / 2 = 1/13 of +x, 2/13 texels: 9/26
    // of the column beyond, half of it of this row.
    EXPECT_NEAR(seamless[1], 9.0F / 52, 1e-5F);
    EXPECT_GT(seamless[0] + seamless[2], 0);
}

TEST(Contributions, CountWhatOneSees) {
    Flat flat;
    flat.scene.textures[0].magFilter = MagFilter::Nearest;
    flat.scene.passes.push_back(flat.scene.passes[0]);
    const TexelPlace first{0, {0, 0, 0}};
    EXPECT_THAT(flat.row({.pass = 0, .texel = first}), ElementsAre(0, 0, 0, 0)); // drawn over
    EXPECT_THAT(flat.row({.pass = 1, .texel = first}), ElementsAre(1, 1, 0, 0));
    flat.scene.passes[1].blend = true;
    EXPECT_THAT(flat.row({.pass = 0, .texel = first}), ElementsAre(1, 1, 0, 0));
    flat.scene.passes[1].blend = false;
    flat.scene.passes[1].alphaTest = true;
    flat.scene.passes[1].alphaFunc = CompareFunc::Never;
    EXPECT_THAT(flat.row({.pass = 0, .texel = first}), ElementsAre(1, 1, 0, 0));
    flat.scene.models[0].visible = false;
    EXPECT_THAT(flat.row({.pass = 0, .texel = first}), ElementsAre(0, 0, 0, 0));
}

// Both directions of the same question have one answer.
TEST(Contributions, AgreeWithTheProbe) {
    Scene scene = defaultScene();
    scene.models[1].shape = Shape::Floor;
    scene.textures[0].maxAnisotropy = 4;
    const ImageSource images;
    ReferenceRenderer renderer;
    constexpr int width = 24;
    constexpr int height = 16;
    const TexelQuestion question{.texel = {4, {2, 1, 0}}};
    const Result<Contributions> found = renderer.contributions({scene, images, 0, width, height}, question);
    ASSERT_TRUE(found);
    float sum = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Result<Explanation> pixel = renderer.probe({scene, images, 0, width, height}, {x, y});
            ASSERT_TRUE(pixel);
            float weight = 0;
            if (const FragmentExplanation* seen = pixel->seen(); seen && !seen->units.empty()) {
                for (const Tap& tap : seen->units[0].sample.taps)
                    weight += tap.level == 4 && tap.index == glm::ivec3(2, 1, 0) ? tap.weight : 0;
            }
            EXPECT_NEAR(found->weights[static_cast<std::size_t>(y * width + x)], weight, 1e-6F);
            sum += weight;
        }
    }
    EXPECT_GT(sum, 0);
}

struct Refused {
    const char* name;
    TexelQuestion question;
    const char* expected;
};
class BadTexel : public testing::TestWithParam<Refused> {};
TEST_P(BadTexel, IsRefusedWithItsNumbers) {
    const Flat flat;
    const Result<Contributions> found =
        contributions({flat.scene, flat.images, 0, 4, 4}, GetParam().question);
    ASSERT_FALSE(found);
    EXPECT_THAT(found.error().message, HasSubstr(GetParam().expected));
}
INSTANTIATE_TEST_SUITE_P(
    All, BadTexel,
    testing::Values(Refused{"Pass", {.pass = 1}, "no pass 1, the scene has 1"},
                    Refused{"NegativePass", {.pass = -1}, "no pass -1"},
                    Refused{"Unit", {.unit = 4}, "a unit from 0 to 3, found 4"},
                    Refused{"UnitThatIsOff", {.unit = 1}, "passes[0].units[1] samples nothing"},
                    Refused{"Level", {.texel = {1, {0, 0, 0}}}, "without a level 1: it has 1"},
                    Refused{"Left", {.texel = {0, {-2, 0, 0}}}, "expected i from -1 to 2"},
                    Refused{"Above", {.texel = {0, {0, 2, 0}}}, "expected j from -1 to 1"},
                    Refused{"Depth", {.texel = {0, {0, 0, 1}}}, "expected k from 0 to 0"}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::contributions_test
