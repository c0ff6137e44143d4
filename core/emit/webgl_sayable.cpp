// What WebGL 2 has no words for.

#include "core/emit/webgl.h"
#include "core/scene/drawn_models.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

Error lacking(const std::string& path, const std::string& key, std::string_view what) {
    return {ErrorCode::Unsupported, fmt::format("WebGL 2 has no {}", what), fmt::format("{}.{}", path, key)};
}

Result<void> isSayable(const Texture& texture, const TextureCode& code, const Unit& unit,
                       const std::string& path) {
    if (code.border != 0)
        return fail(lacking(path, keyOf<&Texture::border>(), "textures with a border"));
    if (code.driverCompresses)
        return fail(lacking(path, keyOf<&Texture::compression>(), "compression by the driver"));
    if (code.blocks == BlockFormat::Bc4Signed || code.blocks == BlockFormat::Bc5Signed)
        return fail(lacking(path, keyOf<&Texture::file>(), "texels below 0 in 8 bits that are filtered"));
    const std::array wraps{std::pair{&keyOf<&Texture::wrapS>(), texture.wrapS},
                           std::pair{&keyOf<&Texture::wrapT>(), texture.wrapT},
                           std::pair{&keyOf<&Texture::wrapR>(), texture.wrapR}};
    const int count = unit.target == Target::CubeMap ? 0 : coordinatesOf(unit.target);
    for (int i = 0; i < count; ++i) {
        const auto& [key, wrap] = wraps.at(static_cast<std::size_t>(i));
        if (wrap == Wrap::ClampToBorder || (wrap == Wrap::Clamp && !readsNearestAlone(texture)))
            return fail(lacking(path, *key, rowOf(wrap).name));
    }
    if (isDepth(code.shape.internalFormat) && texture.compareMode == CompareMode::None &&
        !readsNearestAlone(texture))
        return fail(lacking(path, keyOf<&Texture::magFilter>(), "averages of depths that aren't compared"));
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
            if (const Result<void> said = isSayable(scene.textures[texture], *glsl.emission.codeOf(unit),
                                                    unit, elementOf<&Scene::textures>(texture));
                !said)
                return said;
            if (unit.target == Target::CubeMap && !drawn.seamlessCubeMap &&
                !readsNearestAlone(scene.textures[texture]))
                return fail(ErrorCode::Unsupported,
                            "WebGL 2 always filters across the edges of a cube map: switch it on",
                            fmt::format("{}.{}", elementOf<&Scene::passes>(pass.index),
                                        keyOf<&Pass::seamlessCubeMap>()));
            if (unit.emboss.enabled && pass.units[i]->lateFlip == LateFlip::Coordinates)
                return fail(ErrorCode::Unsupported,
                            "coordinates of an image that lies upside down can't be moved",
                            fmt::format("{}.{}.{}", elementOf<&Scene::passes>(pass.index),
                                        elementOf<&Pass::units>(i), keyOf<&Unit::emboss>()));
        }
        for (const std::size_t model : drawnModels(scene, drawn)) {
            if (partCorners(scene.models[model]) == 2 && scene.models[model].lineWidth != 1)
                return fail(lacking(elementOf<&Scene::models>(model), keyOf<&Model::lineWidth>(),
                                    "lines of another width than 1"));
        }
    }
    return {};
}

} // namespace texplorer::emit
