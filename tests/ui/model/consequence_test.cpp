#include "app/ui/model/consequence.h"

#include <gtest/gtest.h>

namespace texplorer::consequence_test {
namespace {

using namespace ui;
using reference::LevelShare;
using reference::UnitExplanation;

using enum MinFilter;

struct Case {
    const char* says;
    double texelsPerPixel;
    std::vector<LevelShare> levels{};
    MinFilter minification = Nearest;
    int probes = 1;
    MagFilter magnification = MagFilter::Linear;
    Target target = Target::Texture2D;
};

TEST(Consequence, IsOneSentence) {
    const std::vector<Case> cases{
        {.says = "Magnified 8×: the nearest texel",
         .texelsPerPixel = 0.125,
         .levels = {{0, 1}},
         .magnification = MagFilter::Nearest},
        {"Magnified 8×: linear, of 4 texels", 0.125, {{0, 1}}},
        {.says = "Magnified 2.5×: linear, of 2 texels",
         .texelsPerPixel = 0.4,
         .levels = {{0, 1}},
         .target = Target::Texture1D},
        {.says = "Magnified 1×: linear, of 8 texels",
         .texelsPerPixel = 1,
         .levels = {{0, 1}},
         .target = Target::Texture3D},
        {"Minified 4×: the nearest texel of level 0, without mipmaps", 4, {{0, 1}}, Nearest},
        {"Minified 4×: linear in level 0, without mipmaps", 4, {{0, 1}}, Linear},
        {"Minified 4×: linear in level 2", 4, {{2, 1}}, LinearMipmapNearest},
        {"Minified 4×: the nearest texel of level 2", 4, {{2, 1}}, NearestMipmapNearest},
        {"Minified 5×: 68 % of level 2, 32 % of level 3", 5, {{2, 0.678F}, {3, 0.322F}}, LinearMipmapLinear},
        {"Minified 4×: linear in level 2", 4, {{2, 1}, {3, 0}}, LinearMipmapLinear},
        {"Minified 2×: 8 samples along the footprint, level 1", 2, {{1, 1}}, LinearMipmapLinear, 8},
        {"Minified 1.6×: 4 samples along the footprint, 31 % of level 0, 69 % of level 1",
         1.6,
         {{0, 0.307F}, {1, 0.693F}},
         LinearMipmapLinear,
         4},
        {"Minified 1.6×: 4 samples along the footprint, level 1",
         1.6,
         {{0, 0}, {1, 1}},
         LinearMipmapLinear,
         4},
        {"Minified 120×: linear in level 7", 120.4, {{7, 1}}, LinearMipmapNearest},
        {"The level of detail is undefined here", 0, {{0, 1}}},
        {"The level of detail is undefined here", 1},
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
