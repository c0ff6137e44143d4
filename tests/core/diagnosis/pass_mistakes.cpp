#include "tests/core/diagnosis/mistakes.h"

#include <cmath>
#include <limits>

namespace texplorer::test {
namespace {

using enum Severity;

constexpr float infinite = std::numeric_limits<float>::infinity();

constexpr std::array
    passRows{
        Mistake{"InfiniteCoordinate", "infinite-coordinate", Error, "models[0].texCoords0[1]",
                "the same is true of 1 more",
                [](Subject& s) {
                    s.scene.models[0].texCoords[0] = {{0, 0, 0, 1}, {infinite, 0, 0, 1}, {0, NAN, 0, 1}};
                },
                [](Subject& s) { s.scene.models[0].texCoords[0].clear(); }},
        Mistake{"ZeroQ", "zero-q-of-vertex", Warning, "models[0].texCoords0[0]", "q of vertex 0 is 0",
                [](Subject& s) {
                    s.scene.models[0].texCoords[0] = {{1, 1, 0, 0}};
                },
                [](Subject& s) { s.unit().enabled = false; }},
        Mistake{"NothingPassesAlpha", "nothing-passes", Warning, "passes[0].alphaFunc", "draws nothing",
                [](Subject& s) {
                    s.pass().alphaTest = true;
                    s.pass().alphaFunc = CompareFunc::Never;
                }},
        Mistake{"NothingPassesDepth", "nothing-passes", Warning, "passes[0].depthFunc", "draws nothing",
                [](Subject& s) { s.pass().depthFunc = CompareFunc::Never; }},
        Mistake{"SecondPassWithLess", "hidden-pass", Warning, "passes[1].depthFunc",
                "no depth is less than itself", [](Subject& s) { s.scene.passes.push_back(s.pass()); }},
        Mistake{"NoDepthTest", "no-depth-test", Warning, "passes[0].depthTest", "covers nearer surfaces",
                [](Subject& s) { s.pass().depthTest = false; }},
        Mistake{"NoDepthTestOfOneSquare", "no-depth-test", Warning, "passes[0].depthTest", "no depth test",
                [](Subject& s) { s.pass().depthTest = false; },
                [](Subject& s) {
                    s.scene.models.resize(1);
                    s.scene.models[0].shape = Shape::Quad;
                }},
        Mistake{"NoDepthTestOfSquaresBehindEachOther", "no-depth-test", Warning, "passes[0].depthTest",
                "no depth test",
                [](Subject& s) {
                    s.pass().depthTest = false;
                    s.scene.models.assign(2, {.shape = Shape::Quad});
                    s.scene.models[1].position.z = -1;
                },
                [](Subject& s) {
                    s.scene.models[1].position = {3, 0, 0};
                }},
        Mistake{"NoDepthTestOfWhatIsBlended", "no-depth-test", Warning, "passes[1].depthTest",
                "no depth test",
                [](Subject& s) {
                    s.scene.passes.push_back({});
                    s.scene.passes[1].blend = true;
                },
                [](Subject& s) { s.scene.passes[1].blendDst = BlendFactor::One; }},
        Mistake{"DepthFunc", "fragment-test", Hint, "passes[0].depthFunc", "off",
                [](Subject& s) { s.pass().depthTest = false; },
                [](Subject& s) { s.pass().depthTest = true; }},
        Mistake{"AlphaFunc", "fragment-test", Hint, "passes[0].alphaFunc", "off", [](Subject&) {},
                [](Subject& s) { s.pass().alphaTest = true; }},
        Mistake{"AlphaRef", "fragment-test", Hint, "passes[0].alphaRef", "GL_ALWAYS compares nothing",
                [](Subject& s) { s.pass().alphaTest = true; },
                [](Subject& s) { s.pass().alphaFunc = CompareFunc::Greater; }},
        Mistake{"BlendFactor", "fragment-test", Hint, "passes[0].blendDst", "off", [](Subject&) {},
                [](Subject& s) { s.pass().blend = true; }},
        Mistake{"BlendThatReplaces", "fragment-test", Hint, "passes[0].blend", "as without",
                [](Subject& s) { s.pass().blend = true; },
                [](Subject& s) { s.pass().blendDst = BlendFactor::One; }},
        Mistake{"Light", "light", Hint, "light", "no pass has lighting",
                [](Subject& s) { s.pass().lighting = false; }, [](Subject& s) { s.pass().lighting = true; }},
        Mistake{"ShininessWithoutLight", "light", Hint, "material.shininess", "no pass has lighting",
                [](Subject& s) { s.pass().lighting = false; }, [](Subject& s) { s.pass().lighting = true; }},
        Mistake{"ShininessOfNothing", "light", Hint, "material.shininess", "black",
                [](Subject& s) {
                    s.scene.light.specular = {0, 0, 0, 1};
                },
                [](Subject& s) {
                    s.scene.light.specular = {0, 1, 0, 1};
                }},
        Mistake{"LightOnADullMaterial", "light", Hint, "light.specular",
                "material's specular colour is black",
                [](Subject& s) {
                    s.scene.material.specular = {0, 0, 0, 1};
                },
                [](Subject& s) {
                    s.scene.material.specular = {1, 1, 1, 1};
                }},
        Mistake{
            "ColorUnderReplace", "color", Hint, "material.color", "replace the primary colour",
            [](Subject& s) { s.unit().envMode = EnvMode::Replace; },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Luminance; }}, // its alpha stays
        Mistake{"ColorUnderReplaceOfOnePass", "color", Hint, "material.color", "replace the primary colour",
                [](Subject& s) { s.unit().envMode = EnvMode::Replace; },
                [](Subject& s) {
                    s.scene.passes.push_back(s.pass());
                    s.scene.passes[1].units[0].enabled = false;
                }},
        Mistake{"LightingUnderReplace", "lighting", Hint, "passes[0].lighting", "replace the primary colour",
                [](Subject& s) { s.unit().envMode = EnvMode::Replace; },
                [](Subject& s) { s.scene.light.colorControl = ColorControl::SeparateSpecular; }},
        Mistake{"LightingUnderReplaceOfLuminance", "lighting", Hint, "passes[0].lighting", "primary colour",
                [](Subject& s) {
                    s.unit().envMode = EnvMode::Replace;
                    s.texture().internalFormat = InternalFormat::Luminance;
                },
                [](Subject& s) { s.texture().internalFormat = InternalFormat::Alpha; }},
        Mistake{"SpecularUnderReplace", "light", Hint, "material.specular", "replace the primary colour",
                [](Subject& s) { s.unit().envMode = EnvMode::Replace; },
                [](Subject& s) { s.scene.light.colorControl = ColorControl::SeparateSpecular; }},
        Mistake{"ShininessUnderReplace", "light", Hint, "material.shininess", "replace the primary colour",
                [](Subject& s) { s.unit().envMode = EnvMode::Replace; },
                [](Subject& s) { s.unit().envMode = EnvMode::Decal; }},
        Mistake{"DiffuseUnderReplaceAndSeparate", "light", Hint, "light.diffuse",
                "replace the primary colour",
                [](Subject& s) {
                    s.unit().envMode = EnvMode::Replace;
                    s.scene.light.colorControl = ColorControl::SeparateSpecular;
                },
                [](Subject& s) { s.unit().enabled = false; }},
        Mistake{"TwoSidesWithoutLight", "light", Hint, "light.twoSide", "replace the primary colour",
                [](Subject& s) { s.unit().envMode = EnvMode::Replace; },
                [](Subject& s) { s.unit().envMode = EnvMode::Modulate; }},
        Mistake{"TwoSidesOfClosedShapes", "two-sides", Hint, "light.twoSide", "closed and seen from outside",
                [](Subject&) {}, [](Subject& s) { s.scene.models[0].shape = Shape::Quad; }},
        Mistake{"TwoSidesWithoutADepthTest", "two-sides", Hint, "light.twoSide", "closed", [](Subject&) {},
                [](Subject& s) { s.pass().depthTest = false; }},
        Mistake{"TwoSidesSeenFromInside", "two-sides", Hint, "light.twoSide", "closed", [](Subject&) {},
                [](Subject& s) { s.scene.models[0].size = 9; }},
        Mistake{"TwoSidesOfAMirroredShape", "two-sides", Hint, "light.twoSide", "closed", [](Subject&) {},
                [](Subject& s) { s.scene.models[0].scale.y = -1; }},
        Mistake{"DarkBackOfASquare", "dark-back", Warning, "light.twoSide", "the back of models[0]",
                [](Subject& s) {
                    s.scene.models[0].shape = Shape::Quad;
                    s.scene.models[0].rotation = {0, 180, 0};
                    s.scene.light.position = {0, 0, 1, 0};
                }},
        Mistake{"DarkBackUnlessTheLightIsThere", "dark-back", Warning, "light.twoSide", "stays dark",
                [](Subject& s) {
                    s.scene.models[1].shape = Shape::Disk;
                    s.scene.models[1].rotation = {0, 180, 0};
                    s.scene.light.position = {0, 0, 1, 0};
                },
                [](Subject& s) {
                    s.scene.light.position = {0, 0, -1, 0};
                }},
        Mistake{"DarkInsideOfACylinder", "dark-back", Warning, "light.twoSide", "the back of models[0]",
                [](Subject& s) {
                    s.scene.models[0].shape = Shape::Cylinder;
                    s.scene.models[0].rotation = {60, 0, 0};
                },
                [](Subject& s) {
                    s.scene.models[0].rotation = {0, 0, 0};
                    s.scene.view.elevation = 0;
                }},
        Mistake{"FogOfTheInitialState", "fog-of-no-use", Warning, "passes[0].fog.density",
                "everything is "
                "hidden",
                [](Subject& s) { s.pass().fog.enabled = true; }},
        Mistake{"FogSquaredTooThick", "fog-of-no-use", Warning, "passes[0].fog.density",
                "everything is hidden",
                [](Subject& s) { s.pass().fog = {.enabled = true, .mode = FogMode::Exp2}; }},
        Mistake{"FogWithoutDensity", "fog-of-no-use", Warning, "passes[0].fog.density", "hides nothing",
                [](Subject& s) { s.pass().fog = {.enabled = true, .density = 0}; }},
        Mistake{"LinearFogOfTheInitialState", "fog-of-no-use", Warning, "passes[0].fog.end",
                "everything is "
                "hidden",
                [](Subject& s) { s.pass().fog = {.enabled = true, .mode = FogMode::Linear}; }},
        Mistake{"LinearFogBehindEverything", "fog-of-no-use", Warning, "passes[0].fog.end", "hides nothing",
                [](Subject& s) {
                    s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 50, .end = 90};
                }},
        Mistake{"LinearFogBeforeAFlatThing", "fog-of-no-use", Warning, "passes[0].fog.end",
                "everything is "
                "hidden",
                [](Subject& s) {
                    s.scene.models.resize(1);
                    s.scene.models[0] = {};
                    s.scene.models[0].shape = Shape::Quad;
                    s.scene.view.azimuth = s.scene.view.elevation = 0;
                    s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
                }},
        // The fix ends at the limit of its row, or there is none within it.
        Mistake{"LinearFogFarAway", "fog-of-no-use", Warning, "passes[0].fog.end", "everything is hidden",
                [](Subject& s) {
                    s.scene.models.resize(1);
                    s.scene.models[0].size = 100;
                    s.scene.view.distance = 990;
                    s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
                }},
        Mistake{"LinearFogTooFarAway", "fog-of-no-use", Warning, "passes[0].fog.end", "everything is hidden",
                [](Subject& s) {
                    s.scene.models.resize(1);
                    s.scene.models[0].position.z = -1000;
                    s.scene.view.distance = 1000;
                    s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
                }},
        Mistake{"FogBackwards", "fog-range", Warning, "passes[0].fog.end", "ends at 2, before it starts at 9",
                [](Subject& s) {
                    s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 9, .end = 2};
                }},
        Mistake{"FogWithoutLength", "fog-range", Warning, "passes[0].fog.end", "divides by 0",
                [](Subject& s) {
                    s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 5, .end = 5};
                }},
        Mistake{"FogOfAnotherColor", "fog-color", Warning, "passes[0].fog.color", "stand out",
                [](Subject& s) {
                    s.scene.models[0].shape = Shape::Floor;
                    s.pass().fog = {.enabled = true, .density = 0.1F, .color = {1, 0.5F, 0, 1}};
                }},
        Mistake{"StacksOfATeapot", "too-many-stacks", Warning, "models[0].stacks", "has at most 24",
                [](Subject& s) {
                    s.scene.models[0].shape = Shape::Teapot;
                    s.scene.models[0].stacks = 25;
                }},
        Mistake{"FogOff", "fog", Hint, "passes[0].fog.color", "the fog is off", [](Subject&) {},
                [](Subject& s) { s.pass().fog.enabled = true; }},
        Mistake{"DensityOfLinearFog", "fog", Hint, "passes[0].fog.density", "GL_LINEAR has a start",
                [](Subject& s) { s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .end = 9}; },
                [](Subject& s) { s.pass().fog.mode = FogMode::Exp; }},
        Mistake{"StartOfExponentialFog", "fog", Hint, "passes[0].fog.start", "GL_EXP2 has a density",
                [](Subject& s) { s.pass().fog = {.enabled = true, .mode = FogMode::Exp2, .density = 0.1F}; },
                [](Subject& s) { s.pass().fog.mode = FogMode::Linear; }},
        Mistake{"PassOfHiddenModels", "empty-pass", Warning, "passes[0].models", "it draws nothing",
                [](Subject& s) {
                    s.pass().models = {0};
                    s.scene.models[0].visible = false;
                },
                [](Subject& s) { s.scene.models[0].visible = true; }},
        Mistake{"PassOff", "pass-off", Hint, "passes[0]", "not drawn",
                [](Subject& s) { s.scene.passes[0].enabled = false; }},
        Mistake{"TextureOfAPassThatIsOff", "texture-not-shown", Hint, "textures[0]", "the pass that shows",
                [](Subject& s) { s.scene.passes[0].enabled = false; }},
        Mistake{"HiddenModel", "hidden-model", Hint, "models[1]", "hidden",
                [](Subject& s) { s.scene.models[1].visible = false; }},
        Mistake{"CoordinatesOfAUnitThatIsOff", "unread-coordinates", Hint, "models[0].texCoords2",
                "unit 2 is off",
                [](Subject& s) {
                    s.scene.models[0].texCoords[2].assign(24, {1, 1, 0, 1});
                },
                [](Subject& s) { s.unit(2).enabled = true; }},
        Mistake{"KeysOfCallsOfAUnitThatIsOff", "unread-coordinates", Hint, "models[0].noTexCoord2",
                "unit 2 is off",
                [](Subject& s) {
                    s.scene.timeline.keys = {{.time = 1, .path = "models[0].noTexCoord2", .value = "3"}};
                },
                [](Subject& s) { s.unit(2).enabled = true; }},
        Mistake{
            "CoordinatesOfAUnitThatMakesItsOwn", "unread-coordinates", Hint, "models[0].texCoords0",
            "unit 0 generates all of its coordinates",
            [](Subject& s) {
                s.scene.models[0].texCoords[0].assign(24, {1, 1, 0, 1});
                for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR, &Unit::texGenQ})
                    (s.unit().*each).enabled = true;
            },
            [](Subject& s) { s.unit().texGenQ.enabled = false; }},
        Mistake{"SlicesOfACube", "other-shape", Unused, "models[0].slices", "\"Cube\"", [](Subject&) {},
                [](Subject& s) { s.scene.models[0].shape = Shape::Sphere; }}};

} // namespace

std::span<const Mistake> passMistakes() {
    return passRows;
}

} // namespace texplorer::test
