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

/// A green tree of 32 × 32 texels, and black where alpha is 0; at its edge alpha is 0 or 1, which takes two
/// steps.
Result<void> fringe(const PresetTarget& target) {
    showPattern(target.texture, Pattern::Tree);
    using enum ComponentSource;
    const ImageStep zeroOrOne{.op = ImageOp::Scale, .factor = glm::vec4(16), .bias = glm::vec4(-7.5F)};
    target.texture.preparation = {
        {.op = ImageOp::Resize, .share = 1.0F / 8},
        {.op = ImageOp::Swizzle, .red = Zero, .green = Alpha, .blue = Zero, .alpha = Alpha},
        zeroOrOne,
        zeroOrOne};
    target.texture.magFilter = MagFilter::Linear;
    target.texture.wrapS = target.texture.wrapT = Wrap::ClampToEdge;
    takeGivenCoordinates(target.unit);
    target.unit.envMode = EnvMode::Replace;
    blendWith(target.pass, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha);
    showSquare(target.scene);
    target.scene.view.background = paper;
    return {};
}

/// Error: the preparation is full.
Result<void> endWith(Texture& texture, ImageOp op) {
    if (!texture.preparation.empty() && texture.preparation.back().op == op)
        return {};
    if (texture.preparation.size() >= maxImageSteps)
        return fail(ErrorCode::TooLarge,
                    Sentence("the image is already prepared by {0} steps", maxImageSteps));
    texture.preparation.push_back({.op = op});
    return {};
}

Result<void> fringeCure(const PresetTarget& target) {
    blendWith(target.pass, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha);
    return endWith(target.texture, ImageOp::Spread);
}

Result<void> fringePremultiplied(const PresetTarget& target) {
    blendWith(target.pass, BlendFactor::One, BlendFactor::OneMinusSrcAlpha);
    return endWith(target.texture, ImageOp::Premultiply);
}

/// A net, the mortar between bricks, on a floor: alpha is 1 where the height is below a half, in green.
Result<void> vanishing(const PresetTarget& target) {
    showFloor(target);
    showPattern(target.texture, Pattern::BrickHeight);
    target.texture.preparation = {{.op = ImageOp::Swizzle, .alpha = ComponentSource::Red},
                                  {.op = ImageOp::Scale, .factor = {1, 1, 1, -16}, .bias = {0, 0.5F, 0, 8}}};
    filterTrilinear(target.texture);
    target.texture.mipCoverage = 0;
    target.texture.wrapS = target.texture.wrapT = Wrap::Repeat;
    target.unit.envMode = EnvMode::Replace;
    testAlpha(target.pass);
    return {};
}

Result<void> vanishingCure(const PresetTarget& target) {
    filterTrilinear(target.texture);
    target.texture.mipCoverage = target.pass.alphaRef;
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
    Preset{"fringe", alphaGroup, N_("Dark fringe"),
           N_("A sprite of few texels, black where alpha is 0, blended with GL_SRC_ALPHA and "
              "GL_ONE_MINUS_SRC_ALPHA."),
           N_("A dark line around the tree: GL_LINEAR mixes the black of invisible texels into its edge."),
           fringe},
    Preset{"fringe-cure", alphaGroup, N_("Dark fringe, cured"),
           N_("A step that gives invisible texels the colours of the nearest visible ones."),
           N_("The edge has the tree's own colour: what GL_LINEAR mixes in is the same green."), fringeCure,
           true},
    Preset{
        "fringe-premultiplied", alphaGroup, N_("Dark fringe, premultiplied"),
        N_("A step that multiplies colours by alpha, and blending with GL_ONE and GL_ONE_MINUS_SRC_ALPHA."),
        N_("The edge has the tree's own colour: filters weigh each colour by its alpha."),
        fringePremultiplied, true},
    Preset{"vanishing", alphaGroup, N_("Vanishing net"),
           N_("A net that recedes into the distance, with the alpha test and mipmaps."),
           N_("Far away the net is gone: each level averages alpha, and where less than half of an image is "
              "opaque, no mean passes the test."),
           vanishing},
    Preset{"vanishing-cure", alphaGroup, N_("Vanishing net, cured"),
           N_("Levels whose alpha is scaled, so that as many texels pass the alpha test as of the image."),
           N_("The net goes on into the distance, as dense as it is near."), vanishingCure, true},
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
