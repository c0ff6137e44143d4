#include "core/scene/params/scene_check.h"

#include "core/base/count.h"

#include <fmt/core.h>

namespace texplorer {

Result<void> checkTexCoordCount(const Model& model, const TexCoords& list) {
    const std::size_t count = vertexCount(model.shape, model.slices, model.stacks);
    if (list.empty() || list.size() == count)
        return {};
    return fail(ErrorCode::OutOfRange,
                fmt::format("expected {} coordinates, one for each vertex of the {}, or none; found {}",
                            count, rowOf(model.shape).name, list.size()));
}

Result<void> checkUnitTexture(const Scene& scene, const Unit& unit) {
    const std::size_t count = scene.textures.size();
    if (!unit.enabled || static_cast<std::size_t>(unit.texture) < count)
        return {};
    return fail(
        ErrorCode::OutOfRange,
        fmt::format("an enabled unit needs a texture that exists: it asks for number {}, the scene has {}",
                    unit.texture, countOf(count, "texture")));
}

} // namespace texplorer
