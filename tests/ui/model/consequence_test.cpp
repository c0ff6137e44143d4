#include "app/ui/model/consequence.h"

#include <gtest/gtest.h>

namespace texplorer::consequence_test {
namespace {

using namespace ui;
using reference::LevelShare;
using reference::UnitExplanation;

struct Case {
    const char* says;
    MagFilter magnification;
    MinFilter minification;
    double texelsPerPixel;
    std::vector<LevelShare> levels;
    Target target = Target::Texture2D;
    int probes = 1;
};

TEST(Consequence, IsOneSentence) {
    const std::vector<Case> cases{
        {"Magnified 8×: the nearest texel", MagFilter::Nearest, MinFilter::Nearest, 0.125, {{0, 1}}},
        {"Magnified 8×: linear, of 4 texels", MagFilter::Linear, MinFilter::Nearest, 0.125, {{0, 1}}},
        {"Magnified 2.5×: linear, of 2 texels",
         MagFilter::Linear,
         MinFilter::Nearest,
         0.4,
         {{0, 1}},
         Target::Texture1D},
        {"Magnified 1×: linear, of 8 texels",
         MagFilter::Linear,
         MinFilter::Nearest,
         1,
         {{0, 1}},
         Target::Texture3D},
        {"Minified 4×: the nearest texel of level 0, without mipmaps",
         MagFilter::Linear,
         MinFilter::Nearest,
         4,
         {{0, 1}}},
        {"Minified 4×: linear in level 0, without mipmaps",
         MagFilter::Linear,
         MinFilter::Linear,
         4,
         {{0, 1}}},
        {"Minified 4×: linear in level 2", MagFilter::Linear, MinFilter::LinearMipmapNearest, 4, {{2, 1}}},
        {"Minified 4×: the nearest texel of level 2",
         MagFilter::Linear,
         MinFilter::NearestMipmapNearest,
         4,
         {{2, 1}}},
        {"Minified 5×: 68 % of level 2, 32 % of level 3",
         MagFilter::Linear,
         MinFilter::LinearMipmapLinear,
         5,
         {{2, 0.678F}, {3, 0.322F}}},
        {"Minified 4×: linear in level 2",
         MagFilter::Linear,
         MinFilter::LinearMipmapLinear,
         4,
         {{2, 1}, {3, 0}}},
        {"Minified 2×: 8 samples along the footprint, level 1",
         MagFilter::Linear,
         MinFilter::LinearMipmapLinear,
         2,
         {{1, 1}},
         Target::Texture2D,
         8},
        {"Minified 1.6×: 4 samples along the footprint, 31 % of level 0, 69 % of level 1",
         MagFilter::Linear,
         MinFilter::LinearMipmapLinear,
         1.6,
         {{0, 0.307F}, {1, 0.693F}},
         Target::Texture2D,
         4},
        {"Minified 1.6×: 4 samples along the footprint, level 1",
         MagFilter::Linear,
         MinFilter::LinearMipmapLinear,
         1.6,
         {{0, 0}, {1, 1}},
         Target::Texture2D,
         4},
        {"Minified 120×: linear in level 7",
         MagFilter::Linear,
         MinFilter::LinearMipmapNearest,
         120.4,
         {{7, 1}}},
        {"The level of detail is undefined here", MagFilter::Linear, MinFilter::Nearest, 0, {{0, 1}}},
        {"The level of detail is undefined here", MagFilter::Linear, MinFilter::Nearest, 1, {}},
    };
    for (const Case& each : cases) {
        UnitExplanation unit;
        unit.target = each.target;
        unit.sampler.magFilter = each.magnification;
        unit.sampler.minFilter = each.minification;
        unit.sample.lod.rho = each.texelsPerPixel;
        unit.sample.lod.magnified = each.texelsPerPixel <= 1;
        unit.sample.lod.probes = each.probes;
        unit.sample.levels = each.levels;
        EXPECT_EQ(consequenceOf(unit), each.says);
    }
}

TEST(State, SaysWhatWasChangedAndWhetherItIsSaved) {
    Document document(defaultScene(), ImageSource{});
    EXPECT_EQ(stateOf(document), "Nothing to save yet");
    document.file = "/scenes/earth.json";
    EXPECT_EQ(stateOf(document), "earth.json is saved");
    document.scene.textures.front().wrapS = Wrap::Clamp;
    document.history.record(document.scene, "Wrap s");
    EXPECT_EQ(stateOf(document), "Changed last: Wrap s · not saved");
}

} // namespace
} // namespace texplorer::consequence_test
