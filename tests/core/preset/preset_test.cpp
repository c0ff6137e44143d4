#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/params/scene_diff.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace texplorer::preset_test {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAreArray;

Scene with(std::string_view name, Scene scene = defaultScene(), const PresetPlace& place = {}) {
    const Preset* preset = findPreset(name);
    if (!preset) {
        ADD_FAILURE() << "no preset is called " << name;
        return scene;
    }
    const Result<void> done = applyPreset(*preset, scene, place);
    EXPECT_TRUE(done) << name << ": " << describe(done.error());
    return scene;
}

std::vector<std::string> pathsChanged(const Scene& from, const Scene& to) {
    std::vector<std::string> paths;
    for (const SceneChange& each : changesBetween(from, to))
        paths.push_back(each.path);
    return paths;
}

/// Whether a preset is about what a rule finds.
bool isMeant(std::string_view preset, std::string_view rule) {
    return (preset == "wrong-format" && rule == "format-refused") ||
           (preset == "no-levels" && rule == "incomplete");
}

/// What is wrong: errors and warnings, except calls that don't fit or are left out, which presets are about.
std::vector<std::string> wrongIn(const Scene& scene, std::string_view preset) {
    std::vector<std::string> wrong;
    for (const Finding& each : diagnose(scene, {})) {
        if (isMeant(preset, each.rule))
            continue;
        const bool isOfCalls =
            each.severity == Severity::Warning && (each.path.find(".upload") != std::string::npos ||
                                                   each.path.find(".noTexCoord") != std::string::npos);
        if (each.severity <= Severity::Warning && !isOfCalls)
            wrong.push_back(each.path + ": " + each.sentence.english());
    }
    return wrong;
}

TEST(Presets, HaveNamesThatAreTheirsAndTextsForAStudent) {
    std::set<std::string_view> names;
    std::set<std::string_view> labels;
    std::vector<std::string_view> groups;
    for (const Preset& each : presets()) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        EXPECT_TRUE(labels.insert(each.label).second) << each.label;
        EXPECT_TRUE(each.help.ends_with('.')) << each.name;
        EXPECT_TRUE(each.look.ends_with('.')) << each.name;
        EXPECT_EQ(findPreset(each.name), &each);
        if (groups.empty() || groups.back() != each.group)
            groups.push_back(each.group);
    }
    EXPECT_EQ(std::set(groups.begin(), groups.end()).size(), groups.size())
        << "those of a group stand together";
    EXPECT_EQ(findPreset("no-such"), nullptr);
    EXPECT_EQ(findPreset(""), nullptr);
}

struct Changed {
    std::string_view name;
    std::string_view before; ///< applied first; empty: nothing
    std::vector<std::string> paths;
};

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Of one of the default scene's units.
std::vector<std::string> inUnit(int unit, const std::vector<std::string>& keys) {
    std::vector<std::string> paths;
    for (const std::string& key : keys)
        paths.push_back("passes[0].units[" + std::to_string(unit) + "]." + key);
    return paths;
}

std::vector<Changed> changedRows() {
    const std::vector<std::string> floor{"view.azimuth",     "view.elevation", "view.distance",
                                         "view.target",      "models",         "models[0].visible",
                                         "models[1].visible"};
    const std::vector<std::string> wraps{"textures[0].wrapS", "textures[0].wrapT"};
    const std::vector<std::string> alphaTest{"passes[0].alphaTest", "passes[0].alphaFunc",
                                             "passes[0].alphaRef"};
    const std::vector<std::string> blend{"passes[0].blend", "passes[0].blendSrc", "passes[0].blendDst"};
    const std::vector<std::string> light{"texGenS.enabled", "texGenT.enabled",  "texGenR.enabled",
                                         "texGenQ.enabled", "texGenR.eyePlane", "texGenQ.eyePlane",
                                         "matrix"};
    const std::string pattern = "textures[0].pattern";
    return {
        {"shimmer", "", joined(joined(floor, {"textures[0].minFilter"}), inUnit(0, {"matrix"}))},
        {"shimmer-cure", "shimmer", {"textures[0].minFilter"}},
        {"blocks", "", {pattern, "textures[0].magFilter", "textures[0].baseLevel"}},
        {"blocks-cure", "blocks", {"textures[0].magFilter"}},
        {"seam", "",
         joined(wraps,
                {pattern, "textures[0].minFilter", "textures[0].baseLevel", "textures[0].borderColor"})},
        {"seam-cure", "seam", wraps},
        {"atlas-bleeding", "",
         joined(inUnit(0, {"envMode"}),
                {pattern, "textures[0].baseLevel", "textures[0].preparation", "view.azimuth",
                 "view.elevation", "view.distance", "models", "models[0].visible", "models[1].visible"})},
        {"atlas-bleeding-cure", "atlas-bleeding", {"textures[0].maxLevel", "models[2].texCoords0"}},
        {"coloured-levels", "", joined(floor, {"textures[0].mipmaps"})},
        {"anisotropy", "", joined(floor, {"textures[0].maxAnisotropy"})},
        {"alpha-blending", "", joined(blend, {pattern})},
        {"alpha-test", "", joined(alphaTest, {pattern})},
        {"cut-out", "",
         joined(joined(joined(alphaTest, wraps), inUnit(0, {"envMode"})),
                {pattern, "view.azimuth", "view.elevation", "view.distance", "models", "models[0].visible",
                 "models[1].visible"})},
        {"fringe", "",
         joined(joined(joined(blend, wraps), inUnit(0, {"envMode"})),
                {pattern, "textures[0].preparation", "view.azimuth", "view.elevation", "view.distance",
                 "view.background", "models", "models[0].visible", "models[1].visible"})},
        {"fringe-cure", "fringe", {"textures[0].preparation"}},
        {"fringe-premultiplied", "fringe", {"textures[0].preparation", "passes[0].blendSrc"}},
        {"vanishing", "",
         joined(joined(joined(floor, alphaTest), inUnit(0, {"envMode"})),
                {pattern, "textures[0].preparation"})},
        {"vanishing-cure", "vanishing", {"textures[0].mipCoverage"}},
        {"additive-glow", "", joined(blend, {"passes[0].depthTest"})},
        {"scroll", "", inUnit(0, {"matrix"})},
        {"spin", "", inUnit(0, {"matrix"})},
        {"rotate-centre", "", inUnit(0, {"matrix"})},
        {"pulse", "", inUnit(0, {"matrix"})},
        {"sphere-map", "",
         joined(inUnit(0, {"texGenS.enabled", "texGenS.mode", "texGenT.enabled", "texGenT.mode"}),
                {pattern})},
        {"contours", "",
         joined(inUnit(0, {"target", "envMode", "envColor", "texGenS.enabled", "texGenS.mode",
                           "texGenS.objectPlane"}),
                {pattern, "textures[0].internalFormat"})},
        {"reflection", "",
         joined(joined(wraps, {pattern, "textures[0].wrapR"}),
                inUnit(0, {"target", "texGenS.enabled", "texGenS.mode", "texGenT.enabled", "texGenT.mode",
                           "texGenR.enabled", "texGenR.mode"}))},
        {"projector", "", joined(joined(wraps, {pattern, "textures[0].borderColor"}), inUnit(0, light))},
        {"shadow-map", "",
         joined(joined({"models", "textures"}, inUnit(1, light)), inUnit(1, {"enabled", "texture"}))},
        {"decal", "", joined(inUnit(0, {"envMode"}), {pattern, "material.color"})},
        {"detail", "",
         joined(inUnit(1, {"enabled", "texture", "envMode", "combine.rgbScale", "matrix"}), {"textures"})},
        {"wrong-unit", "",
         joined(joined(inUnit(0, {"enabled"}), inUnit(1, {"enabled"})),
                {pattern, "textures[0].magFilter", "textures[0].minFilter", "models[0].noTexCoord1",
                 "models[1].visible", "view.target", "view.distance"})},
        {"wrong-unit-cure", "wrong-unit",
         joined(joined(inUnit(0, {"enabled"}), inUnit(1, {"enabled"})), {"models[0].noTexCoord1"})},
        {"emboss", "",
         joined(joined(inUnit(0, {"envMode"}),
                       {pattern, "textures", "models[1].visible", "view.target", "view.distance"}),
                inUnit(1, {"enabled", "texture", "envMode", "combine.rgb", "combine.operand0Rgb",
                           "emboss.enabled"}))},
        {"slanted",
         "",
         {pattern, "textures[0].mipmaps", "textures[0].minFilter", "textures[0].upload.custom",
          "textures[0].upload.rowLength"}},
        {"swapped-colours",
         "",
         {pattern, "textures[0].mipmaps", "textures[0].minFilter", "textures[0].upload.custom",
          "textures[0].upload.memory", "textures[0].upload.memoryFormat",
          "textures[0].upload.memoryAlignment", "textures[0].upload.format"}},
        {"wrong-format",
         "",
         {pattern, "textures[0].mipmaps", "textures[0].minFilter", "textures[0].internalFormat"}},
        {"no-levels", "", {pattern, "textures[0].mipmaps", "textures[0].minFilter"}},
        {"upside-down", "",
         joined(inUnit(0, {"envMode"}), {pattern, "view.azimuth", "view.elevation", "view.distance", "models",
                                         "models[0].visible", "models[1].visible"})},
        {"upside-down-cure", "upside-down", {"models[2].texCoords0"}},
    };
}

TEST(Presets, ChangeExactlyWhatTheySay) {
    const std::vector<Changed> rows = changedRows();
    EXPECT_EQ(rows.size(), presets().size()) << "each has its row";
    for (const Changed& row : rows) {
        const Scene before = row.before.empty() ? defaultScene() : with(row.before);
        EXPECT_THAT(pathsChanged(before, with(row.name, before)), UnorderedElementsAreArray(row.paths))
            << row.name;
    }
}

TEST(Presets, LeaveAPictureOfOnesOwn) {
    Scene own = defaultScene();
    own.textures[0].source = SourceKind::File;
    own.textures[0].file = "mine.png";
    own.passes[0].lighting = false;
    for (const char* name : {"projector", "sphere-map", "shimmer", "decal", "cut-out", "anisotropy"}) {
        const Texture texture = with(name, own).textures[0];
        EXPECT_EQ(texture.source, SourceKind::File) << name;
        EXPECT_EQ(texture.file, "mine.png") << name;
    }
    EXPECT_TRUE(with("projector", own).passes[0].lighting) << "what is turned away from the light stays dark";
}

TEST(Presets, OnceMoreChangeNothing) {
    for (const Preset& each : presets()) {
        const Scene once = with(each.name);
        EXPECT_THAT(pathsChanged(once, with(each.name, once)), IsEmpty()) << each.name;
    }
}

TEST(Presets, LeaveASceneInWhichNothingIsWrong) {
    for (const Preset& each : presets())
        EXPECT_THAT(wrongIn(with(each.name), each.name), IsEmpty()) << each.name;
}

TEST(Presets, FollowOneAnotherWithoutAnError) {
    for (const Preset& first : presets()) {
        const Scene one = with(first.name);
        for (const Preset& second : presets()) {
            for (const Finding& each : diagnose(with(second.name, one), {}))
                EXPECT_TRUE(each.severity != Severity::Error || isMeant(second.name, each.rule))
                    << first.name << ", " << second.name << ": " << each.path << ": " << each.sentence;
        }
    }
}

TEST(Presets, MakeWhatAnEmptySceneLacks) {
    for (const Preset& each : presets()) {
        const Scene scene = with(each.name, Scene{});
        EXPECT_TRUE(std::ranges::any_of(scene.passes[0].units, &Unit::enabled)) << each.name;
        EXPECT_FALSE(scene.textures.empty()) << each.name;
    }
}

TEST(Presets, AreAboutTheUnitAndThePassThatAreChosen) {
    Scene scene = defaultScene();
    scene.passes.resize(2);
    scene.passes[1].enabled = false;
    scene.passes[1].units[2].texture = 7; // there is none
    const Scene after = with("alpha-test", scene, {1, 2});
    EXPECT_EQ(after.passes[0], scene.passes[0]);
    EXPECT_TRUE(after.passes[1].enabled);
    EXPECT_TRUE(after.passes[1].alphaTest);
    EXPECT_TRUE(after.passes[1].units[2].enabled);
    EXPECT_EQ(after.passes[1].units[2].texture, 1);
    EXPECT_EQ(after.textures[0], scene.textures[0]);
    EXPECT_EQ(after.textures[1].pattern, Pattern::Tree);
}

TEST(Presets, KeepAnImageOfOnesOwn) {
    Scene scene = defaultScene();
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "leaf.png";
    for (const std::string_view name : {"alpha-blending", "alpha-test", "cut-out"}) {
        EXPECT_EQ(with(name, scene).textures[0].file, "leaf.png") << name;
        EXPECT_EQ(with(name, scene).textures[0].source, SourceKind::File) << name;
    }
}

void expectRefused(std::string_view name, const Scene& scene, const PresetPlace& place, ErrorCode code) {
    Scene same = scene;
    const Result<void> done = applyPreset(*findPreset(name), same, place);
    ASSERT_FALSE(done) << name;
    EXPECT_EQ(done.error().code, code) << describe(done.error());
    EXPECT_EQ(same, scene) << "it is what it was before";
}

TEST(Presets, AreRefusedWhereThereIsNoRoom) {
    Scene units = defaultScene();
    for (Unit& unit : units.passes[0].units)
        unit.enabled = true;
    Scene textures = defaultScene();
    textures.textures.resize(maxTextures);
    units.textures.resize(2);
    units.passes[0].units[0].texture = 1; // of no other unit
    expectRefused("wrong-unit", units, {}, ErrorCode::TooLarge);
    expectRefused("wrong-unit", defaultScene(), {0, 3}, ErrorCode::TooLarge);
    for (const std::string_view name : {"detail", "emboss", "shadow-map"}) {
        expectRefused(name, units, {}, ErrorCode::TooLarge);
        expectRefused(name, textures, {}, ErrorCode::TooLarge);
    }
    textures.passes[0].units[3].texture = -1;
    expectRefused("scroll", textures, {0, 3}, ErrorCode::TooLarge);
    expectRefused("scroll", defaultScene(), {1, 0}, ErrorCode::OutOfRange);
    expectRefused("scroll", defaultScene(), {0, maxUnits}, ErrorCode::OutOfRange);
    expectRefused("detail", defaultScene(), {0, 3}, ErrorCode::TooLarge);
}

TEST(Presets, OfAPatternReadItAsItIs) {
    const Scene slanted = with("slanted");
    EXPECT_EQ(with("cut-out", slanted).textures[0].upload, Upload{});
    EXPECT_EQ(with("blocks", slanted).textures[0].upload, Upload{});
}

TEST(Presets, KeepNoPaperButTheirCuresDo) {
    const Scene fringe = with("fringe");
    EXPECT_EQ(with("fringe-cure", fringe).view.background, glm::vec4(1));
    EXPECT_EQ(with("blocks", fringe).view.background, defaultScene().view.background);
    Scene own = defaultScene();
    own.view.background = {1, 0, 0, 1};
    EXPECT_EQ(with("blocks", own).view.background, own.view.background);
}

TEST(Presets, CureAnImageFromItsOwnUnit) {
    const Scene cured = with("wrong-unit-cure", with("wrong-unit"), {0, 1});
    EXPECT_TRUE(cured.passes[0].units[0].enabled);
    EXPECT_FALSE(cured.passes[0].units[1].enabled);
    EXPECT_THAT(cured.models[0].noTexCoord[1], IsEmpty());
}

TEST(Presets, FindRoomAmongManyModels) {
    Scene scene = defaultScene();
    scene.models.resize(maxModels);
    EXPECT_EQ(with("shadow-map", scene).models.size(), maxModels);
    EXPECT_EQ(with("shimmer", scene).models.back().shape, Shape::Floor);
}

} // namespace
} // namespace texplorer::preset_test
