#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

constexpr std::array unitRows{
    Mistake{"DepthWithoutEmboss", "emboss", Hint, "passes[0].units[0].emboss.depth", "don't follow the light",
            [](Subject&) {}, [](Subject& s) { s.unit().emboss.enabled = true; }},
    Mistake{"StepBeforeAnother", "matrix-replaced", Hint, "passes[0].units[0].matrix[0]",
            "step 2 loads another matrix",
            [](Subject& s) {
                s.unit().matrix = {{.op = MatrixOp::Translate}, {.op = MatrixOp::Load}};
            },
            [](Subject& s) { s.unit().matrix[1].op = MatrixOp::Multiply; }},
    Mistake{"NoSuchTexture", "missing-texture", Error, "passes[0].units[0].texture", "there is no texture 7",
            [](Subject& s) { s.unit().texture = 7; }},
    Mistake{"NegativeTexture", "missing-texture", Error, "passes[0].units[0].texture",
            "there is no texture -1", [](Subject& s) { s.unit().texture = -1; }},
    Mistake{"NoTextureAtAll", "missing-texture", Error, "passes[0].units[0].texture", "the scene has 0",
            [](Subject& s) { s.scene.textures.clear(); }},
    Mistake{"TooFewUnits", "unit-limit", Warning, "passes[0].units[2].enabled", "has 2 texture units",
            [](Subject& s) {
                s.driver.textureUnits = 2;
                s.unit(2).enabled = true;
            },
            [](Subject& s) { s.driver.textureUnits = 3; }},
    Mistake{"OneUnit", "unit-limit", Warning, "passes[0].units[1].enabled",
            "has 1 texture unit: drawn without this one; one more pass with its texture alone, blended "
            "with GL_DST_COLOR and GL_ZERO",
            [](Subject& s) {
                s.driver.textureUnits = 1;
                s.unit(1).enabled = true;
            }},
    Mistake{"OneUnitThatCombines", "unit-limit", Warning, "passes[0].units[1].enabled",
            "use more passes with blending instead of more units",
            [](Subject& s) {
                s.driver.textureUnits = 1;
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Combine;
            }},
    Mistake{"DecalOfLuminance", "undefined-decal", Warning, "passes[0].units[0].envMode",
            "GL_LUMINANCE texture",
            [](Subject& s) {
                s.unit().envMode = EnvMode::Decal;
                s.texture().internalFormat = InternalFormat::Luminance;
            }},
    Mistake{"DecalOfIntensity", "undefined-decal", Warning, "passes[0].units[0].envMode", "GL_INTENSITY",
            [](Subject& s) {
                s.unit().envMode = EnvMode::Decal;
                s.texture().internalFormat = InternalFormat::Intensity;
            },
            [](Subject& s) { s.texture().compression = Compression::Driver; }},
    Mistake{"CrossbarOfAUnitThatIsOff", "undefined-crossbar", Warning,
            "passes[0].units[0].combine.source1Rgb", "GL_TEXTURE2 is undefined: unit 2 is off",
            [](Subject& s) { s.combine().source1Rgb = CombineSource::Texture2; }},
    Mistake{"CrossbarOfAUnitWithoutTexture", "undefined-crossbar", Warning,
            "passes[0].units[0].combine.source1Rgb",
            "GL_TEXTURE2 is undefined: unit 2 has no complete texture",
            [](Subject& s) {
                s.combine().source1Rgb = CombineSource::Texture2;
                s.unit(2).enabled = true;
                s.unit(2).texture = 9;
            },
            [](Subject& s) { s.unit(2).texture = 0; }},
    Mistake{"CoordinatesWithoutDirection", "no-tangent", Warning, "passes[0].units[0].emboss.enabled",
            "at all of the 24 vertices of models[0] the coordinates give no direction on the surface",
            [](Subject& s) {
                s.scene.models[0].texCoords[0].assign(24, {0, 0, 0, 1});
                s.unit().emboss.enabled = true;
            },
            [](Subject& s) { s.unit().emboss.enabled = false; }},
    Mistake{"CoordinatesWithoutDirectionAtThePoles", "no-tangent", Warning,
            "passes[0].units[0].emboss.enabled",
            " vertices of models[1] the coordinates give no direction on the surface",
            [](Subject& s) { s.unit().emboss.enabled = true; },
            [](Subject& s) { s.scene.models[1].visible = false; }},
    Mistake{"CrossbarSwitchedOn", "undefined-crossbar", Warning, "passes[0].units[0].combine.source0Alpha",
            "GL_TEXTURE1", [](Subject& s) { s.combine().source0Alpha = CombineSource::Texture1; },
            [](Subject& s) { s.unit(1).enabled = true; }},
    Mistake{"CrossbarOfAnUnreadArgument", "undefined-crossbar", Warning,
            "passes[0].units[0].combine.source2Rgb", "unit 3",
            [](Subject& s) {
                s.combine().source2Rgb = CombineSource::Texture3;
                s.combine().rgb = CombineRgb::Interpolate;
            },
            [](Subject& s) { s.combine().rgb = CombineRgb::Modulate; }},
    Mistake{"ScaleOfZero", "collapsing-matrix", Warning, "passes[0].units[0].matrix[0].amount", "same t",
            [](Subject& s) {
                s.unit().matrix = {{MatrixOp::Scale, {2, 0, 0}}};
            }},
    Mistake{"AxisOfZero", "collapsing-matrix", Warning, "passes[0].units[0].matrix[0].amount", "length 0",
            [](Subject& s) {
                s.unit().matrix = {{MatrixOp::Rotate, {0, 0, 0}}};
            }},
    Mistake{"GeneratedQ", "zero-q", Warning, "passes[0].units[0].texGenQ.eyePlane", "q 0 everywhere",
            [](Subject& s) { s.unit().texGenQ.enabled = true; }},
    Mistake{"GeneratedQOfTheObject", "zero-q", Warning, "passes[0].units[0].texGenQ.objectPlane", "q 0",
            [](Subject& s) {
                s.unit().texGenQ.enabled = true;
                s.unit().texGenQ.mode = TexGenMode::ObjectLinear;
            }},
    Mistake{"EnvColor", "env-color", Hint, "passes[0].units[0].envColor", "GL_CONSTANT", [](Subject&) {},
            [](Subject& s) { s.unit().envMode = EnvMode::Blend; }},
    Mistake{"EnvColorOfAlphaBlend", "env-color", Hint, "passes[0].units[0].envColor", "GL_BLEND",
            [](Subject& s) {
                s.unit().envMode = EnvMode::Blend;
                s.texture().internalFormat = InternalFormat::Alpha;
            },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Luminance; }},
    Mistake{"EnvColorOfCombine", "env-color", Hint, "passes[0].units[0].envColor", "GL_COMBINE",
            [](Subject& s) { s.combine(); }, [](Subject& s) { s.combine().rgb = CombineRgb::Interpolate; }},
    Mistake{"LodBias", "lod-bias", Hint, "passes[0].units[0].lodBias", "no mipmaps",
            [](Subject& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Subject& s) { s.texture().minFilter = MinFilter::Nearest; }},
    Mistake{"PlaneOfTheOtherMode", "generation", Hint, "passes[0].units[0].texGenS.objectPlane",
            "GL_EYE_LINEAR does not", [](Subject& s) { s.unit().texGenS.enabled = true; },
            [](Subject& s) { s.unit().texGenS.mode = TexGenMode::ObjectLinear; }},
    Mistake{"GenerationOff", "generation", Hint, "passes[0].units[0].texGenT.mode", "own coordinate",
            [](Subject&) {}, [](Subject& s) { s.unit().texGenT.enabled = true; }},
    Mistake{"GeneratedRUnread", "generation", Hint, "passes[0].units[0].texGenR.enabled", "GL_TEXTURE_2D",
            [](Subject& s) { s.unit().texGenR.enabled = true; },
            [](Subject& s) {
                s.unit().matrix.push_back({MatrixOp::Rotate, {1, 0, 0}});
            }},
    Mistake{"SecondArgument", "unread-argument", Hint, "passes[0].units[0].combine.operand1Rgb",
            "GL_REPLACE reads 1 argument", [](Subject& s) { s.combine().rgb = CombineRgb::Replace; },
            [](Subject& s) { s.combine().rgb = CombineRgb::Subtract; }},
    Mistake{"AlphaOfDot3", "unread-argument", Hint, "passes[0].units[0].combine.alpha", "GL_DOT3_RGBA",
            [](Subject& s) { s.combine().rgb = CombineRgb::Dot3Rgba; },
            [](Subject& s) { s.combine().rgb = CombineRgb::Dot3Rgb; }},
    Mistake{"CombineUnderModulate", "other-environment", Unused, "passes[0].units[0].combine", "GL_MODULATE",
            [](Subject&) {}, [](Subject& s) { s.combine(); }},
    Mistake{"UnitOff", "unit-off", Hint, "passes[0].units[0]", "the unit is off",
            [](Subject& s) {
                s.unit().enabled = false;
                s.unit().envMode = EnvMode::Replace;
            }},
    Mistake{"ItsTextureNotShown", "texture-not-shown", Hint, "textures[0]", "no enabled unit",
            [](Subject& s) { s.unit().enabled = false; }},
    Mistake{"OverruledByReplace", "overruled-unit", Hint, "passes[0].units[0]", "unit 1",
            [](Subject& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Replace;
            },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Rgb; }},
    Mistake{"OverruledUnlessAsked", "overruled-unit", Hint, "passes[0].units[0]", "unit 1",
            [](Subject& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Combine;
                s.unit(1).combine.source1Rgb = CombineSource::Texture;
                s.unit(1).combine.source1Alpha = CombineSource::Texture;
            },
            [](Subject& s) { s.unit(1).combine.source0Rgb = CombineSource::Texture0; }},
    Mistake{"OverruledByTwoTogether", "overruled-unit", Hint, "passes[0].units[0]", "unit 2",
            [](Subject& s) {
                s.unit(1).enabled = s.unit(2).enabled = true;
                for (std::size_t u = 1; u <= 2; ++u) {
                    s.unit(u).envMode = EnvMode::Combine;
                    s.unit(u).combine.rgb = CombineRgb::Replace;
                    s.unit(u).combine.alpha = CombineAlpha::Replace;
                }
                s.unit(1).combine.source0Alpha = CombineSource::Previous; // its colour is the texture's
                s.unit(2).combine.source0Rgb = CombineSource::Previous;   // its alpha is the texture's
            },
            [](Subject& s) { s.unit(2).combine.source0Alpha = CombineSource::Previous; }},
    Mistake{"OverruledButAskedForItsTexture", "overruled-unit", Hint, "passes[0].units[0].envMode", "unit 1",
            [](Subject& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Combine;
                s.unit(1).combine.rgb = CombineRgb::Replace;
                s.unit(1).combine.alpha = CombineAlpha::Replace;
                s.unit(1).combine.source0Rgb = CombineSource::Texture0;
            },
            [](Subject& s) { s.unit(1).combine.source0Alpha = CombineSource::Previous; }},
    Mistake{"OverruledUnlessTheDriverLacksTheUnit", "overruled-unit", Hint, "passes[0].units[0]", "unit 1",
            [](Subject& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Replace;
            },
            [](Subject& s) { s.driver.textureUnits = 1; }},
    Mistake{"TextureOfAnOverruledUnit", "overruled-texture", Hint, "textures[0]", "replace the result",
            [](Subject& s) {
                s.scene.textures.push_back(s.texture());
                s.unit(1).enabled = true;
                s.unit(1).texture = 1;
                s.unit(1).envMode = EnvMode::Replace;
            },
            [](Subject& s) { s.unit(1).texture = 0; }},
    Mistake{"OverruledUnlessItIsUndefined", "overruled-unit", Hint, "passes[0].units[0]", "unit 2",
            [](Subject& s) {
                s.unit(1).enabled = s.unit(2).enabled = true;
                s.unit(2).envMode = EnvMode::Combine;
                s.unit(2).combine.rgb = CombineRgb::Replace;
                s.unit(2).combine.alpha = CombineAlpha::Replace;
                s.unit(2).combine.source0Rgb = CombineSource::Texture1;
                s.unit(2).combine.source0Alpha = CombineSource::Texture1;
            },
            [](Subject& s) { s.unit(1).enabled = false; }},
    Mistake{"AngleOfAScale", "other-matrix-operation", Unused, "passes[0].units[0].matrix[0].angle", "Rotate",
            [](Subject& s) {
                s.unit().matrix = {{MatrixOp::Scale, {1, 1, 1}}};
            },
            [](Subject& s) { s.unit().matrix[0].op = MatrixOp::Rotate; }},
    Mistake{"ScaleOfZeroOfAModel", "collapsing-matrix", Warning, "models[1].units[0].matrix[0].amount",
            "same t",
            [](Subject& s) {
                s.scene.models[1].units[0].matrix = {{MatrixOp::Scale, {2, 0, 0}}};
            },
            [](Subject& s) { s.scene.models[1].visible = false; }},
    Mistake{"ForgottenPop", "forgotten-pop", Warning, "models[0].pushMatrix", "drawn later: models[1]",
            [](Subject& s) {
                s.scene.models[0].units[0].matrix = {{MatrixOp::Scale, {2, 2, 1}}};
                s.scene.models[0].pushMatrix = false;
            },
            [](Subject& s) {
                s.pass().models = {1, 0};
            }},
    Mistake{"ForgottenPopInALaterPass", "forgotten-pop", Warning, "models[1].pushMatrix",
            "models[0], models[1]",
            [](Subject& s) {
                s.scene.models[1].units[0].matrix = {{MatrixOp::Scale, {2, 2, 1}}};
                s.scene.models[1].pushMatrix = false;
                s.scene.passes.push_back(s.pass());
                s.scene.passes[1].units[0].matrixStart = MatrixStart::Keep;
            },
            [](Subject& s) { s.scene.passes[1].units[0].matrixStart = MatrixStart::Identity; }},
    Mistake{"DeepStack", "matrix-stack-depth", Warning, "passes[0].units[0].matrixStart",
            "needs a stack of 3, and OpenGL guarantees 2",
            [](Subject& s) {
                s.scene.models[0].units[0].matrix = {{MatrixOp::Scale, {2, 2, 1}}};
                s.unit().matrixStart = MatrixStart::Push;
            },
            [](Subject& s) { s.scene.models[0].pushMatrix = false; }},
    Mistake{"NothingToStartWith", "matrix-start", Hint, "passes[0].units[0].matrixStart", "no earlier pass",
            [](Subject&) {},
            [](Subject& s) {
                s.scene.passes.push_back(s.pass());
                s.scene.passes[1].units[0].matrixStart = MatrixStart::Push;
            }},
    Mistake{"NothingToPush", "model-steps", Hint, "models[1].pushMatrix", "no steps of its own",
            [](Subject&) {}, [](Subject& s) { s.scene.models[1].units[0].matrix.resize(1); }},
    Mistake{"StepsOfAUnitThatIsOff", "model-steps", Hint, "models[1].units[2]", "is off in all passes",
            [](Subject& s) { s.scene.models[1].units[2].matrix.resize(1); },
            [](Subject& s) { s.unit(2).enabled = true; }}};

} // namespace

std::span<const Mistake> unitMistakes() {
    return unitRows;
}

} // namespace texplorer::test
