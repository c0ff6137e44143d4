#include "core/scene/params/scene_check.h"

namespace texplorer {

Result<void> checkTexCoordCount(const Model& model, const TexCoords& list) {
    const std::size_t count = vertexCount(model.shape, model.slices, model.stacks);
    if (list.empty() || list.size() == count)
        return {};
    return fail(ErrorCode::OutOfRange,
                "expected " + std::to_string(count) + " coordinates, one for each vertex of the " +
                    std::string(rowOf(model.shape).name) + ", or none; found " + std::to_string(list.size()));
}

Result<void> checkUnitTexture(const Scene& scene, const Unit& unit) {
    const std::size_t count = scene.textures.size();
    if (!unit.enabled || static_cast<std::size_t>(unit.texture) < count)
        return {};
    return fail(ErrorCode::OutOfRange, "an enabled unit needs a texture that exists: it asks for number " +
                                           std::to_string(unit.texture) + ", the scene has " +
                                           std::to_string(count) + (count == 1 ? " texture" : " textures"));
}

} // namespace texplorer
