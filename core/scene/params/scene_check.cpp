#include "core/scene/params/scene_check.h"

#include "core/base/count.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer {

namespace {

tl::unexpected<Error> refuseElement(std::size_t index, std::string sentence) {
    return fail(ErrorCode::OutOfRange, std::move(sentence), fmt::format("/{}", index));
}

} // namespace

Result<void> checkMeshList(const MeshData& mesh, const ParamRow& row) {
    const std::size_t vertices = mesh.positions.size();
    if (row.member == memberId<&MeshData::indices>) {
        const auto beyond = std::ranges::find_if(
            mesh.indices, [&](int index) { return static_cast<std::size_t>(index) >= vertices; });
        if (beyond == mesh.indices.end())
            return {};
        return refuseElement(
            static_cast<std::size_t>(beyond - mesh.indices.begin()),
            fmt::format("expected the number of a position, the mesh has {}; found {}", vertices, *beyond));
    }
    const std::size_t count = listSize(row.read(&mesh));
    if (count == 0 || count == vertices)
        return {};
    return fail(ErrorCode::OutOfRange,
                fmt::format("expected {}, one for each position, or none; found {}", vertices, count));
}

Result<void> checkPassModels(const Scene& scene, const Pass& pass) {
    for (std::size_t i = 0; i < pass.models.size(); ++i) {
        const int model = pass.models[i];
        if (static_cast<std::size_t>(model) >= scene.models.size())
            return refuseElement(i, fmt::format("there is no model {}, the scene has {}", model,
                                                countOf(scene.models.size(), "model")));
        const auto end = pass.models.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(pass.models.begin(), end, model) != end)
            return refuseElement(i, fmt::format("expected each model once, found {} twice", model));
    }
    return {};
}

Result<void> checkTexCoordCount(const Model& model, const TexCoords& list) {
    const std::size_t count = vertexCountOf(model);
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
