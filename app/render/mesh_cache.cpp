#include "app/render/mesh_cache.h"

#include "app/render/gl_handle.h"
#include "texplorer/glsl/vertex_attributes.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace texplorer::render {

namespace {

/// A buffer and its name, which is what others see.
struct Owned {
    BufferHandle handle = BufferHandle::create();
    GLuint name = handle.name();
};

view::Buffer makeBuffer(view::BufferKind kind, std::span<const std::byte> content) {
    const GLenum target = kind == view::BufferKind::Indices ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER;
    const auto owned = std::make_shared<const Owned>();
    glBindBuffer(target, owned->name);
    glBufferData(target, static_cast<GLsizeiptr>(content.size()), content.data(), GL_STATIC_DRAW);
    return {owned, &owned->name};
}

/// With a bound buffer, GL takes an offset in bytes instead of a pointer (section 2.9).
const void* offsetInBuffer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr): it is no pointer
}

} // namespace

MeshCache::MeshCache(VertexInput input)
    : input_(input)
    , buffers_(makeBuffer) {}

void MeshCache::beginFrame() {
    bound_ = {};
    buffers_.beginFrame();
}

void MeshCache::bind(const Scene& scene, const Pass& pass, std::size_t index, double time,
                     const std::array<CoordUse, maxUnits>& units) {
    bound_ = buffers_.of(scene, pass, index, time, units);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, **bound_.indices);
    glBindBuffer(GL_ARRAY_BUFFER, **bound_.vertices);
    pointAtVertices();
    for (int unit = 0; unit < maxUnits; ++unit) {
        const view::ModelBuffers::Coords& coords = bound_.coords[static_cast<std::size_t>(unit)];
        if (coords.buffer)
            pointAtCoords(unit, coords);
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

void MeshCache::pointAtCoords(int unit, const view::ModelBuffers::Coords& coords) const {
    glBindBuffer(GL_ARRAY_BUFFER, **coords.buffer);
    const void* offset = offsetInBuffer(coords.offset);
    if (input_ == VertexInput::Attributes) {
        const GLuint attribute = glsl::firstCoordAttribute + static_cast<GLuint>(unit);
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, coords.stride, offset);
        return;
    }
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(4, GL_FLOAT, coords.stride, offset);
}

void MeshCache::draw() const {
    if (!bound_.mesh || bound_.mesh->vertices.empty())
        return;
    std::size_t first = 0;
    const auto drawParts = [&](GLenum primitive, const std::vector<std::uint32_t>& indices) {
        if (!indices.empty())
            glDrawRangeElements(primitive, 0, static_cast<GLuint>(bound_.mesh->vertices.size() - 1),
                                static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT,
                                offsetInBuffer(first * sizeof(std::uint32_t)));
        first += indices.size();
    };
    drawParts(GL_TRIANGLES, bound_.mesh->triangles);
    drawParts(GL_LINES, bound_.mesh->lines);
    drawParts(GL_POINTS, bound_.mesh->points);
}

} // namespace texplorer::render
