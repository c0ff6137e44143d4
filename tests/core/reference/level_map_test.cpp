#include "tests/support/floor_scene.h"
#include "texplorer/reference/level_map.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <cmath>

namespace texplorer::reference::level_map_test {
namespace {

using namespace test;
using testing::HasSubstr;

/// A square that fills a picture of 16 x 16 exactly, without perspective, with a texture of 64 x 64 texels
/// and all its levels: 4 texels a pixel, unless its coordinates say otherwise.
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
        scene.textures[0].pattern = Pattern::Checker;
        scene.textures[0].source = SourceKind::File;
        scene.textures[0].file = "grey";
        scene.textures[0].mipmaps = MipPolicy::Generated;
        scene.passes[0].units[0].enabled = true;
        Image grey = Image::uninitialised(PixelFormat::Luminance8, 64, 64);
        std::ranges::fill(grey.pixels, std::byte{128});
        images.put("grey", std::move(grey));
    }

    /// s, t, r and q at each corner, from where it is: x and y are 0 or 1.
    void setCoords(const std::function<glm::vec4(float x, float y)>& at) {
        TexCoords coords;
        for (const Vertex& vertex : makeMesh({Shape::Quad}).vertices)
            coords.push_back(at(vertex.position.x > 0 ? 1.0F : 0.0F, vertex.position.y > 0 ? 1.0F : 0.0F));
        scene.models[0].texCoords[0] = coords;
    }

    [[nodiscard]] Result<LevelMap> map(const LevelQuestion& question = {}) const {
        return levelMap({scene, images, 0, 16, 16}, question);
    }
    [[nodiscard]] PixelLevels at(int x, int y) const {
        const Result<LevelMap> found = map();
        EXPECT_TRUE(found) << describe(found.error());
        const PixelLevels* pixel = found ? found->at(x, y) : nullptr;
        EXPECT_NE(pixel, nullptr);
        return pixel ? *pixel : PixelLevels{};
    }
};

TEST(LevelMap, HasTheLevelThatIsKnownByHand) {
    Flat flat;
    const PixelLevels four = flat.at(3, 7); // 64 texels on 16 pixels
    EXPECT_FLOAT_EQ(four.lambda, 2);
    EXPECT_FLOAT_EQ(four.ratio, 1);
    EXPECT_EQ(four.first, 2);
    EXPECT_EQ(four.share, 0);
    flat.scene.textures[0].lodBias = 0.25F;
    const PixelLevels biased = flat.at(3, 7);
    EXPECT_FLOAT_EQ(biased.lambda, 2.25F);
    EXPECT_EQ(biased.first, 2);
    EXPECT_EQ(biased.second, 3);
    EXPECT_FLOAT_EQ(biased.share, 0.25F);
    flat.scene.textures[0].maxLod = 1;
    EXPECT_FLOAT_EQ(flat.at(3, 7).lambda, 1);
    flat.scene.textures[0].baseLevel = 1; // λ counts from the base level: 32 texels
    EXPECT_FLOAT_EQ(flat.at(3, 7).lambda, 1);
    EXPECT_EQ(flat.at(3, 7).first, 2);
}

TEST(LevelMap, HasTheRatioOfTheFootprint) {
    Flat flat;
    flat.setCoords([](float x, float y) { return glm::vec4(2 * x, y / 2, 0, 1); }); // 8 by 2 texels a pixel
    EXPECT_FLOAT_EQ(flat.at(5, 5).lambda, 3);
    EXPECT_FLOAT_EQ(flat.at(5, 5).ratio, 4);
    EXPECT_EQ(flat.at(5, 5).samples, 1);
    flat.scene.textures[0].maxAnisotropy = 16;
    EXPECT_FLOAT_EQ(flat.at(5, 5).lambda, 1); // log2(8 / 4)
    EXPECT_FLOAT_EQ(flat.at(5, 5).ratio, 4);
    EXPECT_EQ(flat.at(5, 5).samples, 4);
}

// s = X and q = 1 + X, X from 0 to 1 across the picture: s / q changes by 1 / (1 + X)² along X, which are
// 4 / (1 + X)² texels a pixel.
TEST(LevelMap, FollowsTheDivisionByQ) {
    Flat flat;
    flat.setCoords([](float x, float) { return glm::vec4(x, 0, 0, 1 + x); });
    for (int x = 0; x < 16; ++x) {
        const float place = (static_cast<float>(x) + 0.5F) / 16;
        EXPECT_NEAR(flat.at(x, 4).lambda, 2 - 2 * std::log2(1 + place), 1e-4F) << x;
        EXPECT_TRUE(std::isinf(flat.at(x, 4).ratio)) << "t doesn't change";
    }
}

TEST(LevelMap, HasNothingWhereNothingIsDrawn) {
    Flat flat;
    flat.scene.view.fieldOfView = 127; // about twice as much as the square
    const Result<LevelMap> map = flat.map();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->at(0, 0), nullptr);
    EXPECT_NE(map->at(8, 8), nullptr);
    EXPECT_EQ(map->at(-1, 8), nullptr);
    EXPECT_EQ(map->at(8, 16), nullptr);
}

/// Scenes in which the levels come about in different ways.
struct Case {
    const char* name;
    const char* json;
    AnisotropyMethod anisotropy = AnisotropyMethod::Probes;
};
class LevelMapOf : public testing::TestWithParam<Case> {};

// The probe explains each pixel by itself; both have the same numbers, to the last bit.
TEST_P(LevelMapOf, IsWhatTheProbeExplains) {
    const Result<Scene> scene = parseScene(GetParam().json);
    ASSERT_TRUE(scene) << describe(scene.error());
    constexpr int width = 28;
    constexpr int height = 20;
    ReferenceRenderer renderer;
    const DrawRequest request{*scene, ImageSource(), 0.5, width, height, GetParam().anisotropy};
    for (int pass = 0; pass < static_cast<int>(scene->passes.size()); ++pass) {
        const Result<LevelMap> map = renderer.levels(request, {pass, 0});
        ASSERT_TRUE(map) << describe(map.error());
        int sampled = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const Result<Explanation> pixel = renderer.probe(request, {x, y});
                ASSERT_TRUE(pixel);
                const UnitExplanation* unit = nullptr;
                for (const FragmentExplanation& fragment : pixel->fragments) {
                    if (fragment.pass == pass && fragment.outcome == FragmentOutcome::Drawn)
                        unit = fragment.units.empty() ? nullptr : &fragment.units.front();
                }
                const PixelLevels* found = map->at(x, y);
                ASSERT_EQ(found != nullptr, unit != nullptr) << x << ", " << y;
                if (!unit)
                    continue;
                ++sampled;
                EXPECT_EQ(found->lambda, unit->sample.lod.lambda) << x << ", " << y;
                EXPECT_EQ(map->isMagnified(*found), unit->sample.lod.magnified);
                EXPECT_EQ(found->samples, unit->sample.lod.probes);
                const std::vector<LevelShare>& levels = unit->sample.levels;
                ASSERT_FALSE(levels.empty());
                EXPECT_EQ(found->first, levels.front().level);
                EXPECT_FLOAT_EQ(1 - found->share, levels.front().weight);
                EXPECT_EQ(found->second, levels.back().level);
            }
        }
        EXPECT_GT(sampled, 20);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, LevelMapOf,
    testing::Values(
        Case{"CubeAndSphere", R"({"version": 1, "models": [{"shape": "cube"}, {"shape": "sphere"}],
            "textures": [{"mipmaps": "generated", "minFilter": "GL_LINEAR_MIPMAP_LINEAR"}],
            "passes": [{"depthTest": true, "units": [{"enabled": true}]}]})"},
        Case{"FloorWithSixteenSamples",
             R"({"version": 1, "view": {"azimuth": 20, "elevation": 12}, "models": [{"shape": "floor"}],
            "textures": [{"mipmaps": "generated", "minFilter": "GL_LINEAR_MIPMAP_LINEAR", "maxAnisotropy": 16}],
            "passes": [{"units": [{"enabled": true}]}]})"},
        Case{"FloorByAnEllipse",
             R"({"version": 1, "view": {"azimuth": 20, "elevation": 12}, "models": [{"shape": "floor"}],
            "textures": [{"mipmaps": "generated", "minFilter": "GL_LINEAR_MIPMAP_LINEAR", "maxAnisotropy": 8}],
            "passes": [{"units": [{"enabled": true}]}]})",
             AnisotropyMethod::Ellipse},
        Case{"NearestLevelWithLimits",
             R"({"version": 1, "view": {"elevation": 15}, "models": [{"shape": "floor"}],
            "textures": [{"mipmaps": "generated", "minFilter": "GL_LINEAR_MIPMAP_NEAREST", "lodBias": 0.6,
                          "baseLevel": 1, "maxLevel": 4, "minLod": 0.2, "maxLod": 2.5}],
            "passes": [{"units": [{"enabled": true, "lodBias": -0.2}]}]})"},
        Case{"Line", R"({"version": 1, "models": [{"shape": "sphere"}],
            "textures": [{"mipmaps": "generated"}],
            "passes": [{"depthTest": true, "units": [{"enabled": true, "target": "GL_TEXTURE_1D"}]}]})"},
        Case{"Volume", R"({"version": 1, "models": [{"shape": "sphere"}],
            "textures": [{"mipmaps": "generated"}],
            "passes": [{"depthTest": true, "units": [{"enabled": true, "target": "GL_TEXTURE_3D"}]}]})"},
        Case{"CubeMap", R"({"version": 1, "models": [{"shape": "sphere"}],
            "textures": [{"pattern": "cube-faces", "mipmaps": "generated"}],
            "passes": [{"depthTest": true, "units": [{"enabled": true, "target": "GL_TEXTURE_CUBE_MAP",
                "texGenS": {"enabled": true, "mode": "GL_NORMAL_MAP"},
                "texGenT": {"enabled": true, "mode": "GL_NORMAL_MAP"},
                "texGenR": {"enabled": true, "mode": "GL_NORMAL_MAP"}}]}]})"},
        Case{"LinesAndPoints", R"({"version": 1,
            "models": [{"shape": "mesh", "lineWidth": 5, "mesh": {"primitive": "GL_LINE_STRIP",
                         "positions": [[-1, -1, 0], [0, 1, 0], [1, -1, 0]],
                         "texCoords": [[0, 0], [3, 0], [9, 0]]}},
                       {"shape": "mesh", "pointSize": 6, "mesh": {"primitive": "GL_POINTS",
                         "positions": [[0.5, 0.5, 0], [-1, 0.5, 0]], "texCoords": [[0, 0], [1, 1]]}}],
            "textures": [{"mipmaps": "generated"}],
            "passes": [{"units": [{"enabled": true}]}]})"},
        Case{"TwoPassesOneOverTheOther", R"({"version": 1, "models": [{"shape": "cube"}, {"shape": "sphere"}],
            "textures": [{"mipmaps": "generated"}, {"mipmaps": "generated", "pattern": "tree"}],
            "passes": [{"depthTest": true, "models": [0, 1], "units": [{"enabled": true}]},
                       {"depthTest": true, "depthFunc": "GL_LEQUAL", "blend": true, "models": [0],
                        "alphaTest": true, "alphaFunc": "GL_GREATER", "alphaRef": 0.5,
                        "units": [{"enabled": true, "texture": 1}]}]})"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(LevelMap, SaysItInWords) {
    LevelMap map;
    PixelLevels pixel{.lambda = 1.366F, .ratio = 5.26F, .share = 0.366F, .first = 1, .second = 2};
    EXPECT_EQ(levelsText(map, pixel), "λ = 1.37: 63 % of level 1, 37 % of level 2");
    EXPECT_EQ(footprintText(pixel), "footprint 5.3 : 1");
    pixel.samples = 6;
    EXPECT_EQ(footprintText(pixel), "footprint 5.3 : 1, 6 samples along it");
    pixel.share = 0.001F;
    EXPECT_EQ(levelsText(map, pixel), "λ = 1.37: 99 % of level 1, 1 % of level 2")
        << "never nothing of what is read";
    pixel.share = 0;
    EXPECT_EQ(levelsText(map, pixel), "λ = 1.37: level 1");
    pixel.lambda = -2;
    pixel.first = 0;
    EXPECT_EQ(levelsText(map, pixel), "λ = -2.00: magnified, level 0");
    pixel.ratio = INFINITY;
    EXPECT_EQ(footprintText(pixel), "footprint without a width");
}

TEST(LevelMap, KnowsWhereMagnificationEnds) {
    LevelMap map;
    map.sampler.magFilter = MagFilter::Linear;
    map.sampler.minFilter = MinFilter::NearestMipmapNearest; // c is 1/2
    EXPECT_TRUE(map.isMagnified({.lambda = 0.5F}));
    EXPECT_FALSE(map.isMagnified({.lambda = 0.51F}));
    map.sampler.minFilter = MinFilter::LinearMipmapLinear;
    EXPECT_FALSE(map.isMagnified({.lambda = 0.5F}));
    EXPECT_TRUE(map.isMagnified({.lambda = 0}));
}

struct Refused {
    const char* name;
    LevelQuestion question;
    const char* expected;
};
class BadUnit : public testing::TestWithParam<Refused> {};
TEST_P(BadUnit, IsRefusedWithItsNumbers) {
    const Result<LevelMap> found = Flat().map(GetParam().question);
    ASSERT_FALSE(found);
    EXPECT_THAT(found.error().message, HasSubstr(GetParam().expected));
}
INSTANTIATE_TEST_SUITE_P(All, BadUnit,
                         testing::Values(Refused{"Pass", {1, 0}, "no pass 1, the scene has 1"},
                                         Refused{"NegativePass", {-1, 0}, "no pass -1"},
                                         Refused{"Unit", {0, 4}, "a unit from 0 to 3, found 4"},
                                         Refused{
                                             "UnitThatIsOff", {0, 1}, "passes[0].units[1] samples nothing"}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(LevelMap, RefusesABadSizeAndStops) {
    const Flat flat;
    EXPECT_EQ(levelMap({flat.scene, flat.images, 0, 0, 16}, {}).error().code, ErrorCode::OutOfRange);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(levelMap({flat.scene, flat.images, 0, 16, 16}, {}, {.stop = stop.get_token()}).error().code,
              ErrorCode::Cancelled);
}

} // namespace
} // namespace texplorer::reference::level_map_test
