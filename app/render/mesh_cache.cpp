#include "app/render/mesh_cache.h"

#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <cstddef>
#include <vector>

namespace texplorer::render {

namespace {

template<class T>
BufferHandle makeBuffer(GLenum target, const std::vector<T>& content) {
    BufferHandle buffer = BufferHandle::create();
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(content.size() * sizeof(T)), content.data(), GL_STATIC_DRAW);
    return buffer;
}

/// With a bound buffer, GL takes an offset in bytes instead of a pointer (section 2.9).
const void* offsetInBuffer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr): it is no pointer
}

void forgetUnused(auto& slots) {
    std::erase_if(slots, [](const auto& entry) { return !entry.second.used; });
    for (auto& [key, slot] : slots)
        slot.used = false;
}

} // namespace

void MeshCache::beginFrame() {
    bound_ = nullptr;
    forgetUnused(meshes_);
    forgetUnused(coords_);
}

MeshCache::MeshKey MeshCache::keyOf(const Model& model, std::size_t index) {
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

MeshCache::MeshSlot& MeshCache::meshOf(const Model& model, std::size_t index) {
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
    slot.vertices = makeBuffer(GL_ARRAY_BUFFER, slot.mesh.vertices);
    slot.indices = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    return slot;
}

const Model& MeshCache::sentModel(const Model& model, std::size_t index) {
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

void MeshCache::bind(const Scene& scene, const Pass& pass, std::size_t index, double time,
                     const std::array<CoordUse, maxUnits>& units) {
    const Model& sent = sentModel(scene.models[index], index);
    const MeshSlot& slot = meshOf(sent, index);
    bound_ = &slot;

    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, slot.indices.name());
    glBindBuffer(GL_ARRAY_BUFFER, slot.vertices.name());
    pointAtVertices();
    for (int unit = 0; unit < maxUnits; ++unit) {
        const auto at = static_cast<std::size_t>(unit);
        if (units[at] != CoordUse::Off)
            bindCoords(scene, pass, sent, time, {index, unit, pass.units[at].emboss.enabled}, units[at]);
    }
}

void MeshCache::pointAtVertices() const {
    const void* position = offsetInBuffer(offsetof(Vertex, position));
    const void* normal = offsetInBuffer(offsetof(Vertex, normal));
    const void* color = offsetInBuffer(offsetof(Vertex, color));
    if (input_ == VertexInput::Attributes) {
        glEnableVertexAttribArray(glsl::positionAttribute);
        glVertexAttribPointer(glsl::positionAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), position);
        glEnableVertexAttribArray(glsl::normalAttribute);
        glVertexAttribPointer(glsl::normalAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), normal);
        (hasColors() ? glEnableVertexAttribArray : glDisableVertexAttribArray)(glsl::colorAttribute);
        glVertexAttribPointer(glsl::colorAttribute, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), color);
        return;
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), position);
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, sizeof(Vertex), normal);
    (hasColors() ? glEnableClientState : glDisableClientState)(GL_COLOR_ARRAY);
    glColorPointer(4, GL_FLOAT, sizeof(Vertex), color);
}

void MeshCache::pointAtCoords(int unit, int stride, std::size_t offset) const {
    if (input_ == VertexInput::Attributes) {
        const GLuint attribute = glsl::firstCoordAttribute + static_cast<GLuint>(unit);
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, stride, offsetInBuffer(offset));
        return;
    }
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(4, GL_FLOAT, stride, offsetInBuffer(offset));
}

void MeshCache::bindCoords(const Scene& scene, const Pass& pass, const Model& model, double time,
                           const CoordKey& coordKey, CoordUse use) {
    const MeshSlot& mesh = *bound_;
    const SharedList<glm::vec4>& own = model.texCoords[static_cast<std::size_t>(coordKey.unit)];
    if (own.empty() && !coordKey.embossed && use == CoordUse::AsGiven) {
        glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
        return pointAtCoords(coordKey.unit, sizeof(Vertex), offsetof(Vertex, texCoord));
    }
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
        slot.buffer = makeBuffer(GL_ARRAY_BUFFER, coords);
    }
    slot.used = true;
    glBindBuffer(GL_ARRAY_BUFFER, slot.buffer.name());
    pointAtCoords(coordKey.unit, 0, 0);
}

void MeshCache::draw() const {
    if (!bound_ || bound_->mesh.vertices.empty())
        return;
    std::size_t first = 0;
    const auto drawParts = [&](GLenum primitive, const std::vector<std::uint32_t>& indices) {
        if (!indices.empty())
            glDrawRangeElements(primitive, 0, static_cast<GLuint>(bound_->mesh.vertices.size() - 1),
                                static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT,
                                offsetInBuffer(first * sizeof(std::uint32_t)));
        first += indices.size();
    };
    drawParts(GL_TRIANGLES, bound_->mesh.triangles);
    drawParts(GL_LINES, bound_->mesh.lines);
    drawParts(GL_POINTS, bound_->mesh.points);
}

} // namespace texplorer::render
