// Alpha test and blending.

#include "texplorer/preset/preset_rows.h"
#include "texplorer/scene/show_shapes.h"

#include <algorithm>
#include <array>

namespace texplorer::preset {
namespace {

constexpr std::string_view alphaGroup = N_("Alpha test and blending");
constexpr std::array alphaPatterns{Pattern::Tree, Pattern::LogoOpenGl, Pattern::LogoMultitexture};

/// A picture from a file stays, as does a pattern with alpha.
void showAlpha(const PresetTarget& target) {
    Texture& texture = target.texture;
    generateNothing(target.unit);
    const bool hasAlpha = std::ranges::find(alphaPatterns, texture.pattern) != alphaPatterns.end();
    showPatternUnless(texture, Pattern::Tree,
                      texture.source == SourceKind::File ||
                          (texture.source == SourceKind::Pattern && hasAlpha));
    texture.internalFormat = InternalFormat::Rgba;
}

void testAlpha(Pass& pass) {
    pass.depthTest = true;
    pass.blend = false;
    pass.alphaTest = true;
    pass.alphaFunc = CompareFunc::Greater;
    pass.alphaRef = 0.5F;
}

void blendWith(Pass& pass, BlendFactor source, BlendFactor destination) {
    pass.alphaTest = false;
    pass.blend = true;
    pass.blendSrc = source;
    pass.blendDst = destination;
}

Result<void> alphaBlending(const PresetTarget& target) {
    showAlpha(target);
    target.unit.envMode = EnvMode::Modulate;
    blendWith(target.pass, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha);
    target.pass.depthTest = true;
    return {};
}

Result<void> alphaTest(const PresetTarget& target) {
    showAlpha(target);
    target.unit.envMode = EnvMode::Modulate;
    testAlpha(target.pass);
    return {};
}

Result<void> cutOut(const PresetTarget& target) {
    showAlpha(target);
    takeGivenCoordinates(target.unit);
    target.unit.envMode = EnvMode::Replace;
    target.texture.wrapS = target.texture.wrapT = Wrap::ClampToEdge;
    testAlpha(target.pass);
    showSquare(target.scene);
    return {};
}

Result<void> additiveGlow(const PresetTarget& target) {
    blendWith(target.pass, BlendFactor::SrcAlpha, BlendFactor::One);
    target.pass.depthTest = false;
    return {};
}

constexpr std::array alphaRows{
    Preset{
        "alpha-blending", alphaGroup, N_("Alpha blending"),
        N_("GL_BLEND with GL_SRC_ALPHA and GL_ONE_MINUS_SRC_ALPHA, and an image with alpha."),
        N_("The background shows through where alpha is 0. Far sides are missing there unless they are drawn "
           "first, because transparent fragments also write their depth."),
        alphaBlending},
    Preset{
        "alpha-test", alphaGroup, N_("Alpha test > 0.5"),
        N_("GL_ALPHA_TEST with GL_GREATER and 0.5, and an image with alpha. Blending is off."),
        N_("Fragments with an alpha up to 0.5 are discarded, with their depth, so the far sides show through "
           "the holes."),
        alphaTest},
    Preset{
        "cut-out", alphaGroup, N_("Cut-out"),
        N_("One square with GL_REPLACE, GL_CLAMP_TO_EDGE and the alpha test, as used for plants and fences."),
        N_("Only the shape in the image is left of the square. Move closer: its edge is hard."), cutOut},
    Preset{
        "additive-glow", alphaGroup, N_("Additive glow"),
        N_("GL_BLEND with GL_SRC_ALPHA and GL_ONE, without a depth test."),
        N_("Colours are added to the stored ones, so the model glows. The order of drawing does not matter."),
        additiveGlow},
};

} // namespace

std::span<const Preset> alphaPresets() {
    return alphaRows;
}

} // namespace texplorer::preset
