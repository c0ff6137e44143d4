#include "app/render/mesh_cache.h"

#include "app/render/vertex_attributes.h"
#include "core/scene/tex_coords.h"

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

/// With a buffer bound, GL takes an offset in bytes where it once took a pointer (section 2.9).
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

MeshCache::MeshKey MeshCache::keyOf(const Model& model) {
    const bool subdivided = model.shape == Shape::Sphere;
    return {model.shape, subdivided ? model.slices : 0, subdivided ? model.stacks : 0};
}

MeshCache::MeshSlot& MeshCache::meshOf(const MeshKey& key) {
    auto [found, isNew] = meshes_.try_emplace(key);
    MeshSlot& slot = found->second;
    if (isNew) {
        slot.mesh = makeMesh(key.shape, key.slices, key.stacks);
        slot.vertices = makeBuffer(GL_ARRAY_BUFFER, slot.mesh.vertices);
        slot.triangles = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, slot.mesh.triangles);
    }
    slot.used = true;
    return slot;
}

void MeshCache::bind(const Model& model, std::size_t index, const std::array<CoordUse, maxUnits>& units) {
    const MeshKey key = keyOf(model);
    const MeshSlot& slot = meshOf(key);
    bound_ = &slot;

    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, slot.triangles.name());
    glBindBuffer(GL_ARRAY_BUFFER, slot.vertices.name());
    pointAtVertices();
    for (int unit = 0; unit < maxUnits; ++unit) {
        const CoordUse use = units[static_cast<std::size_t>(unit)];
        if (use == CoordUse::Off)
            continue;
        bindCoords(model, key, {index, unit}, use);
    }
}

void MeshCache::pointAtVertices() const {
    const void* position = offsetInBuffer(offsetof(Vertex, position));
    const void* normal = offsetInBuffer(offsetof(Vertex, normal));
    if (input_ == VertexInput::Attributes) {
        glEnableVertexAttribArray(positionAttribute);
        glVertexAttribPointer(positionAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), position);
        glEnableVertexAttribArray(normalAttribute);
        glVertexAttribPointer(normalAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), normal);
        return;
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), position);
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, sizeof(Vertex), normal);
}

void MeshCache::pointAtCoords(int unit, int stride, std::size_t offset) const {
    if (input_ == VertexInput::Attributes) {
        const GLuint attribute = firstCoordAttribute + static_cast<GLuint>(unit);
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, stride, offsetInBuffer(offset));
        return;
    }
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(4, GL_FLOAT, stride, offsetInBuffer(offset));
}

void MeshCache::bindCoords(const Model& model, const MeshKey& meshKey, const CoordKey& coordKey,
                           CoordUse use) {
    const MeshSlot& mesh = meshOf(meshKey);
    const TexCoords& list = model.texCoords[static_cast<std::size_t>(coordKey.unit)];
    if (list.empty() && use == CoordUse::AsGiven) {
        glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
        return pointAtCoords(coordKey.unit, sizeof(Vertex), offsetof(Vertex, texCoord));
    }
    auto [found, isNew] = coords_.try_emplace(coordKey);
    CoordSlot& slot = found->second;
    if (isNew || slot.list != list || slot.mesh != meshKey || slot.use != use) {
        slot.list = list;
        slot.mesh = meshKey;
        slot.use = use;
        TexCoords coords = effectiveTexCoords(model, mesh.mesh, coordKey.unit);
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
    if (!bound_)
        return;
    glDrawRangeElements(GL_TRIANGLES, 0, static_cast<GLuint>(bound_->mesh.vertices.size() - 1),
                        static_cast<GLsizei>(bound_->mesh.triangles.size()), GL_UNSIGNED_INT,
                        offsetInBuffer(0));
}

} // namespace texplorer::render
