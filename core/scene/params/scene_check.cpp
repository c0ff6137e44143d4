#include "texplorer/scene/params/scene_check.h"

#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/timeline_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

namespace texplorer {

namespace {

tl::unexpected<Error> refuseElement(std::size_t index, Sentence sentence) {
    return fail(ErrorCode::OutOfRange, std::move(sentence), atPointer(fmt::format("/{}", index)));
}

Result<void> at(const std::string& pointer, const Result<void>& checked) {
    if (checked)
        return {};
    return fail(within(atPointer(pointer), checked.error()));
}

/// Numbers below `count`, none of them twice. `missing` is the sentence about one that isn't.
Result<void> checkNumbers(const std::vector<int>& numbers, std::size_t count,
                          const std::function<Sentence(int)>& missing, Sentence::Key<int> twice) {
    std::set<int> found;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (static_cast<std::size_t>(numbers[i]) >= count)
            return refuseElement(i, missing(numbers[i]));
        if (!found.insert(numbers[i]).second)
            return refuseElement(i, Sentence(twice, numbers[i]));
    }
    return {};
}

Result<void> checkModel(const Model& model, const std::string& pointer) {
    for (const ParamRow& row : meshTable().params) {
        if (!isList(row.kind))
            continue;
        if (auto fits = at(fmt::format("{}/mesh/{}", pointer, row.key), checkMeshList(model.mesh, row));
            !fits)
            return fits;
    }
    for (const ParamRow& row : modelTable().params) {
        if (!isList(row.kind))
            continue;
        if (auto fits = at(fmt::format("{}/{}", pointer, row.key), checkVertexList(model, row)); !fits)
            return fits;
    }
    return {};
}

} // namespace

Result<void> checkMeshList(const MeshData& mesh, const ParamRow& row) {
    if (!mesh.file.empty())
        return {}; // its lists are the file's
    const std::size_t vertices = mesh.positions.size();
    if (row.member == memberId<&MeshData::indices>) {
        const auto beyond = std::ranges::find_if(
            mesh.indices, [&](int index) { return static_cast<std::size_t>(index) >= vertices; });
        if (beyond == mesh.indices.end())
            return {};
        return refuseElement(
            static_cast<std::size_t>(beyond - mesh.indices.begin()),
            Sentence("expected the number of a position (the mesh has {0}), found {1}", vertices, *beyond));
    }
    const std::size_t count = listSize(row.read(&mesh));
    if (count == 0 || count == vertices)
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("expected {0}, one for each position, or none; found {1}", vertices, count));
}

Result<void> checkPassModels(const Scene& scene, const Pass& pass) {
    const auto missing = [&](int model) {
        return Sentence("there is no model {0}, the scene has {1}", model,
                        Sentence::plural("{0} model", "{0} models", scene.models.size()));
    };
    return checkNumbers(pass.models, scene.models.size(), missing,
                        N_("expected each model once, found {0} twice"));
}

Result<void> checkVertexList(const Model& model, const ParamRow& row) {
    const Value list = row.read(&model);
    const std::size_t count = vertexCountOf(model);
    if (model.shape == Shape::Mesh && !model.mesh.file.empty() && count == 0 && listSize(list) > 0)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected no list: the vertices are those of {0}, with their own coordinates",
                             ProperName{model.mesh.file}));
    if (const auto* numbers = std::get_if<SharedList<int>>(&list))
        return checkNumbers(
            *numbers, count,
            [&](int number) {
                return Sentence("there is no vertex {0}, the {1} has {2}", number,
                                ProperName{rowOf(model.shape).name},
                                Sentence::plural("{0} vertex", "{0} vertices", count));
            },
            N_("expected each vertex once, found {0} twice"));
    if (listSize(list) == 0 || listSize(list) == count)
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("expected {0} coordinates, one for each vertex of the {1}, or none; found {2}",
                         count, ProperName{rowOf(model.shape).name}, listSize(list)));
}

Result<void> checkUnitTexture(const Scene& scene, const Unit& unit) {
    const std::size_t count = scene.textures.size();
    if (!unit.enabled || static_cast<std::size_t>(unit.texture) < count)
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("an enabled unit needs an existing texture: it uses number {0}, the scene has {1}",
                         unit.texture, Sentence::plural("{0} texture", "{0} textures", count)));
}

Result<void> checkTogether(const Scene& scene) {
    for (std::size_t m = 0; m < scene.models.size(); ++m)
        if (auto fits = checkModel(scene.models[m], fmt::format("/models/{}", m)); !fits)
            return fits;
    for (std::size_t p = 0; p < scene.passes.size(); ++p)
        if (auto fits = at(fmt::format("/passes/{}/models", p), checkPassModels(scene, scene.passes[p]));
            !fits)
            return fits;
    for (std::size_t p = 0; p < scene.passes.size(); ++p)
        for (std::size_t u = 0; u < scene.passes[p].units.size(); ++u)
            if (auto found = at(fmt::format("/passes/{}/units/{}/texture", p, u),
                                checkUnitTexture(scene, scene.passes[p].units[u]));
                !found)
                return found;
    return at(fmt::format("/{}", keyOf<&Scene::timeline>()), checkTimeline(scene));
}

} // namespace texplorer
