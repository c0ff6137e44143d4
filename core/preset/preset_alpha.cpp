// Alpha test and blending.

#include "core/preset/preset_rows.h"
#include "core/scene/show_shapes.h"

#include <algorithm>
#include <array>

namespace texplorer::preset {
namespace {

constexpr std::string_view alphaGroup = "Alpha test and blending";
constexpr std::array alphaPatterns{Pattern::Tree, Pattern::LogoOpenGl, Pattern::LogoMultitexture};

/// A picture of one's own stays, as a pattern with alpha does.
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
    constexpr std::array quad{Shape::Quad};
    showOnlyShapes(target.scene, quad);
    View& view = target.scene.view;
    view.azimuth = view.elevation = view.roll = 0;
    view.target = std::ranges::find(target.scene.models, Shape::Quad, &Model::shape)->position;
    view.distance = 3.6F;
    return {};
}

Result<void> additiveGlow(const PresetTarget& target) {
    blendWith(target.pass, BlendFactor::SrcAlpha, BlendFactor::One);
    target.pass.depthTest = false;
    return {};
}

constexpr std::array alphaRows{
    Preset{
        "alpha-blending", alphaGroup, "Alpha blending",
        "GL_BLEND with GL_SRC_ALPHA and GL_ONE_MINUS_SRC_ALPHA, and an image that has alpha.",
        "The background shows through where alpha is 0. Far sides are missing there unless they were drawn "
        "first: transparent fragments write their depth all the same.",
        alphaBlending},
    Preset{
        "alpha-test", alphaGroup, "Alpha test > 0.5",
        "GL_ALPHA_TEST with GL_GREATER and 0.5, and an image that has alpha. Blending is off.",
        "Fragments with an alpha up to 0.5 are gone, and their depth with them: through the holes one sees "
        "the far sides.",
        alphaTest},
    Preset{"cut-out", alphaGroup, "Cut-out",
           "One square with GL_REPLACE, GL_CLAMP_TO_EDGE and the alpha test, as plants and fences are drawn.",
           "Nothing is left of the square but the shape in the image. Go near: its edge is hard.", cutOut},
    Preset{
        "additive-glow", alphaGroup, "Additive glow",
        "GL_BLEND with GL_SRC_ALPHA and GL_ONE, without a depth test.",
        "What is drawn is added to what is there: it glows, and in whichever order it is drawn, the sum is "
        "the same.",
        additiveGlow},
};

} // namespace

std::span<const Preset> alphaPresets() {
    return alphaRows;
}

} // namespace texplorer::preset
