#include "app/view/model_buffers.h"

#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <vector>

namespace texplorer::view {

namespace {

void forgetUnused(auto& slots) {
    std::erase_if(slots, [](const auto& entry) { return !entry.second.used; });
    for (auto& [key, slot] : slots)
        slot.used = false;
}

} // namespace

void ModelBuffers::beginFrame() {
    forgetUnused(meshes_);
    forgetUnused(coords_);
}

ModelBuffers::MeshKey ModelBuffers::keyOf(const Model& model, std::size_t index) {
    switch (model.shape) {
    case Shape::Mesh:
        return {{.shape = Shape::Mesh}, index};
    case Shape::Cube:
    case Shape::Quad:
    case Shape::Floor: // which have no options
        return {{.shape = model.shape}};
    default:
        return {shapeOptions(model)};
    }
}

ModelBuffers::MeshSlot& ModelBuffers::meshOf(const Model& model, std::size_t index) {
    auto [found, isNew] = meshes_.try_emplace(keyOf(model, index));
    MeshSlot& slot = found->second;
    slot.used = true;
    const bool own = model.shape == Shape::Mesh;
    if (!isNew && (!own || slot.data == model.mesh))
        return slot;
    if (own)
        slot.data = model.mesh;
    slot.mesh = texplorer::meshOf(model);
    slot.version = ++versions_;
    std::vector<std::uint32_t> indices = slot.mesh.triangles;
    indices.insert(indices.end(), slot.mesh.lines.begin(), slot.mesh.lines.end());
    indices.insert(indices.end(), slot.mesh.points.begin(), slot.mesh.points.end());
    slot.vertices = make_(BufferKind::Vertices, std::as_bytes(std::span(slot.mesh.vertices)));
    slot.indices = make_(BufferKind::Indices, std::as_bytes(std::span(indices)));
    return slot;
}

const Model& ModelBuffers::sentModel(const Model& model, std::size_t index) {
    if (!leavesOutCalls(model)) {
        sent_.erase(index);
        return model;
    }
    auto& [given, sent] = sent_[index];
    if (given != model) {
        given = model;
        sent = *SentModel(given);
    }
    return sent;
}

ModelBuffers::Bound ModelBuffers::of(const Scene& scene, const Pass& pass, std::size_t index, double time,
                                     const std::array<CoordUse, maxUnits>& units) {
    const Model& sent = sentModel(scene.models[index], index);
    const MeshSlot& slot = meshOf(sent, index);
    Bound bound{&slot.mesh, &slot.vertices, &slot.indices};
    for (int unit = 0; unit < maxUnits; ++unit) {
        const auto at = static_cast<std::size_t>(unit);
        if (units[at] != CoordUse::Off)
            bound.coords[at] = coordsOf(scene, pass, sent, time, slot,
                                        {index, unit, pass.units[at].emboss.enabled}, units[at]);
    }
    return bound;
}

ModelBuffers::Coords ModelBuffers::coordsOf(const Scene& scene, const Pass& pass, const Model& model,
                                            double time, const MeshSlot& mesh, const CoordKey& coordKey,
                                            CoordUse use) {
    const SharedList<glm::vec4>& own = model.texCoords[static_cast<std::size_t>(coordKey.unit)];
    if (own.empty() && !coordKey.embossed && use == CoordUse::AsGiven)
        return {&mesh.vertices, sizeof(Vertex), offsetof(Vertex, texCoord)};
    SharedList<glm::vec4> embossed; // depend on the time and the light
    if (coordKey.embossed)
        embossed = givenTexCoords(scene, pass, coordKey.unit, model, mesh.mesh, time);
    const SharedList<glm::vec4>& list = coordKey.embossed ? embossed : own;
    auto [found, isNew] = coords_.try_emplace(coordKey);
    CoordSlot& slot = found->second;
    if (isNew || slot.list != list || slot.mesh != mesh.version || slot.use != use) {
        TexCoords coords =
            coordKey.embossed ? embossed.read() : effectiveTexCoords(model, mesh.mesh, coordKey.unit);
        slot.list = list;
        slot.mesh = mesh.version;
        slot.use = use;
        if (use == CoordUse::Flipped) {
            for (glm::vec4& coord : coords)
                coord.t = coord.q - coord.t;
        }
        slot.buffer = make_(BufferKind::Vertices, std::as_bytes(std::span(coords)));
    }
    slot.used = true;
    return {&slot.buffer};
}

} // namespace texplorer::view
