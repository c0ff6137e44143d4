#pragma once

#include "app/view/model_buffers.h"

namespace texplorer::render {

using view::CoordUse;

/// The destination of vertices: the fixed-function arrays (glVertexPointer and similar calls) or the
/// attributes of a shader.
enum class VertexInput : std::uint8_t { FixedArrays, Attributes };

/// Sets OpenGL's vertex arrays to a scene's models.
class MeshCache {
public:
    explicit MeshCache(VertexInput input = VertexInput::FixedArrays);

    /// Starts a frame: removes models that the previous frame did not draw.
    void beginFrame();

    /// Sets the vertex arrays to the model with this index in the scene, for a pass at a time. `units` gives
    /// the coordinates that each texture unit needs.
    void bind(const Scene& scene, const Pass& pass, std::size_t index, double time,
              const std::array<CoordUse, maxUnits>& units);

    /// Whether the bound model has vertex colours.
    [[nodiscard]] bool hasColors() const { return bound_.mesh && bound_.mesh->colored; }

    /// Draws the bound model.
    void draw() const;

private:
    void pointAtVertices() const;
    void pointAtCoords(int unit, const view::ModelBuffers::Coords& coords) const;

    VertexInput input_;
    view::ModelBuffers buffers_;
    view::ModelBuffers::Bound bound_;
};

} // namespace texplorer::render
