#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

constexpr std::array depthRows{
    Mistake{"DepthsOfAVolume", "depth-target", Error, "passes[0].units[0].target", "no depth textures for",
            [](Subject& s) {
                s.texture().internalFormat = InternalFormat::DepthComponent16;
                s.unit().target = Target::Texture3D;
            }},
    Mistake{"DepthsAsColors", "colored-depths", Warning, "textures[0].internalFormat", "greys of 8 bits",
            [](Subject& s) {
                castShadows(s);
                s.texture().internalFormat = InternalFormat::Rgba;
            }},
    Mistake{"DepthsNotCompared", "depths-as-they-are", Note, "textures[0].compareMode", "for shadows",
            [](Subject& s) {
                castShadows(s);
                s.texture().compareMode = CompareMode::None;
            }},
    Mistake{"RIsZero", "compares-nothing", Warning, "passes[0].units[0].texGenR.enabled", "0 everywhere",
            [](Subject& s) {
                s.texture().internalFormat = InternalFormat::DepthComponent16;
                s.texture().compareMode = CompareMode::RToTexture;
            }},
    Mistake{"NotInEyeCoordinates", "projects-nothing", Warning, "passes[0].units[0].matrix[0].op",
            "GL_EYE_LINEAR", [](Subject& s) { s.unit().matrix = {{.op = MatrixOp::Projector}}; }},
    Mistake{"OneOfFourNotGenerated", "projects-nothing", Warning, "passes[0].units[0].matrix[1].op",
            "eye coordinates",
            [](Subject& s) {
                castShadows(s);
                s.unit().texGenQ.enabled = false;
            }},
    Mistake{"ShadowsOfItself", "shadow-acne", Warning, "passes[0].units[0].matrix[0].op", "translates r",
            [](Subject& s) {
                castShadows(s);
                s.unit().matrix.erase(s.unit().matrix.begin());
            }},
    Mistake{"ShadowsMovedTheOtherWay", "shadow-acne", Warning, "passes[0].units[0].matrix[1].op",
            "translates r",
            [](Subject& s) {
                castShadows(s);
                s.unit().matrix[0].amount.z = 0.01F;
            }},
    Mistake{"LightInItsTarget", "light-in-target", Warning, "light.projector.target", "its own target",
            [](Subject& s) {
                castShadows(s);
                s.scene.light.position = {0, 0, -6, 1};
            }},
    Mistake{"LightWithoutDirection", "light-in-target", Warning, "light.position", "length 0",
            [](Subject& s) {
                castShadows(s);
                s.scene.light.position = {0, 0, 0, 0};
            }},
    Mistake{"NearBehindFar", "light-range", Warning, "light.projector.farthest",
            "greater than the "
            "nearest, 20",
            [](Subject& s) {
                castShadows(s);
                s.scene.light.projector.nearest = 20;
                s.scene.light.projector.farthest = 1;
            }},
    Mistake{"NearIsFar", "light-range", Warning, "light.projector.farthest", "greater than the nearest",
            [](Subject& s) {
                castShadows(s);
                s.scene.light.projector.nearest = s.scene.light.projector.farthest;
            }},
    Mistake{
        "BehindTheLight", "behind-the-light", Note, "passes[0].units[0].matrix[1]", "upside down",
        [](Subject& s) {
            castShadows(s);
            s.scene.light.position = {0, 0, -20, 1}; // looks back at its target, and the models lie behind
            s.scene.light.projector.target = {0, 0, -40};
        },
        [](Subject& s) {
            s.scene.light.projector.target = {0, 0, -6};
        }},
    Mistake{"NothingProjected", "projector", Hint, "light.projector", "projector step", [](Subject&) {},
            castShadows},
    Mistake{"ComparingColors", "texture-setting", Hint, "textures[0].compareMode", "holds no depths",
            [](Subject&) {}, castShadows},
    Mistake{"FunctionWithoutComparing", "texture-setting", Hint, "textures[0].compareFunc",
            "nothing is compared: GL_NONE",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::DepthComponent16; }, castShadows},
    Mistake{"SizeOfAPattern", "other-texture-choice", Unused, "textures[0].depthSize", "Built-in",
            [](Subject&) {}, castShadows},
    Mistake{"DepthsCompressed", "texture-setting", Hint, "textures[0].compression", "no compressed depth",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::DepthComponent16; },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Rgba; }}};

} // namespace

std::span<const Mistake> depthMistakes() {
    return depthRows;
}

} // namespace texplorer::test
