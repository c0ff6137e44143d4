// What WebGL 2 has no words for.

#include "texplorer/emit/webgl.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

Result<void> isSayable(const Texture& texture, const TextureCode& code, const Unit& unit,
                       const glsl::SampledUnit& sampled, const std::string& path) {
    if (code.border != 0)
        return refuse("WebGL 2 has no textures with a border", path, keyOf<&Texture::border>());
    if (code.driverCompresses)
        return refuse("WebGL 2 drivers don't compress textures", path, keyOf<&Texture::compression>());
    if (code.blocks == BlockFormat::Bc4Signed || code.blocks == BlockFormat::Bc5Signed)
        return refuse("WebGL 2 can't filter negative texels of 8 bits", path, keyOf<&Texture::file>());
    const std::array wraps{std::pair{&keyOf<&Texture::wrapS>(), texture.wrapS},
                           std::pair{&keyOf<&Texture::wrapT>(), texture.wrapT},
                           std::pair{&keyOf<&Texture::wrapR>(), texture.wrapR}};
    const int count = unit.target == Target::CubeMap ? 0 : coordinatesOf(unit.target);
    for (int i = 0; i < count; ++i) {
        const auto& [key, wrap] = wraps.at(static_cast<std::size_t>(i));
        const bool isBorder =
            wrap == Wrap::ClampToBorder || (wrap == Wrap::Clamp && !readsNearestAlone(texture));
        if (!isBorder)
            continue;
        if (wrap == Wrap::Clamp && sampled.hasDepths)
            return refuse(Sentence("WebGL 2 has no {0}", rowOf(wrap).name), path, *key);
        if (const Result<void> said = checkBorder(texture, sampled, wrap, path, *key); !said)
            return said;
    }
    if (isDepth(code.shape.internalFormat) && texture.compareMode == CompareMode::None &&
        !readsNearestAlone(texture))
        return refuse("WebGL 2 can't filter depths that aren't compared", path, keyOf<&Texture::magFilter>());
    return {};
}

} // namespace

Result<void> sayableInWebGl(const GlslEmission& glsl) {
    const Scene& scene = glsl.emission.scene;
    for (const GlslPass& pass : glsl.passes) {
        const Pass& drawn = scene.passes[pass.index];
        for (std::size_t i = 0; i < maxUnits; ++i) {
            if (!pass.units[i])
                continue;
            const Unit& unit = drawn.units[i];
            const auto texture = static_cast<std::size_t>(unit.texture);
            if (const Result<void> said =
                    isSayable(scene.textures[texture], *glsl.emission.codeOf(unit), unit, *pass.units[i],
                              elementOf<&Scene::textures>(texture));
                !said)
                return said;
            if (unit.target == Target::CubeMap && !drawn.seamlessCubeMap &&
                !readsNearestAlone(scene.textures[texture]))
                return refuse("WebGL 2 always filters across the edges of a cube map: switch Seamless on",
                              elementOf<&Scene::passes>(pass.index), keyOf<&Pass::seamlessCubeMap>());
            if (unit.emboss.enabled && pass.units[i]->lateFlip == LateFlip::Coordinates)
                return refuse(
                    "the shaders can't move coordinates of an upside-down image",
                    fmt::format("{}.{}", elementOf<&Scene::passes>(pass.index), elementOf<&Pass::units>(i)),
                    keyOf<&Unit::emboss>());
        }
        for (const std::size_t model : drawnModels(scene, drawn)) {
            if (partCorners(scene.models[model]) == 2 && scene.models[model].lineWidth != 1)
                return refuse("WebGL 2 has only lines of width 1", elementOf<&Scene::models>(model),
                              keyOf<&Model::lineWidth>());
        }
    }
    return {};
}

} // namespace texplorer::emit
