#pragma once

#include "app/render/gl_handle.h"
#include "core/mesh/mesh.h"
#include "core/scene/scene.h"

#include <compare>
#include <map>

namespace texplorer::render {

/// What a texture unit wants of a model's coordinates.
enum class CoordUse : std::uint8_t {
    Off,
    AsGiven,
    Flipped, ///< t becomes q - t, so that t / q becomes 1 - t / q
};

/// Where vertices go: to the arrays of fixed function (glVertexPointer and its like), or to the attributes of
/// a shader.
enum class VertexInput : std::uint8_t { FixedArrays, Attributes };

/// The vertex and index buffers of a scene's models. They are filled when a shape or a texture coordinate
/// changed.
class MeshCache {
public:
    explicit MeshCache(VertexInput input = VertexInput::FixedArrays)
        : input_(input) {}

    /// Begins a frame: what was not drawn in the one before it is forgotten.
    void beginFrame();

    /// Points the vertex arrays at the model with this index in the scene. `units` says what each texture
    /// unit needs.
    void bind(const Model& model, std::size_t index, const std::array<CoordUse, maxUnits>& units);

    /// Draws the model that is bound.
    void draw() const;

private:
    struct MeshKey {
        Shape shape{};
        int slices = 0;
        int stacks = 0;
        auto operator<=>(const MeshKey&) const = default; // NOLINT(modernize-use-nullptr): there is none
    };
    struct MeshSlot {
        Mesh mesh;
        BufferHandle vertices;
        BufferHandle triangles;
        bool used = true;
    };
    struct CoordKey {
        std::size_t model = 0;
        int unit = 0;
        auto operator<=>(const CoordKey&) const = default; // NOLINT(modernize-use-nullptr)
    };
    struct CoordSlot {
        TexCoords list;
        MeshKey mesh;
        CoordUse use = CoordUse::AsGiven;
        BufferHandle buffer;
        bool used = true;
    };

    static MeshKey keyOf(const Model& model);
    MeshSlot& meshOf(const MeshKey& key);
    void pointAtVertices() const;
    void pointAtCoords(int unit, int stride, std::size_t offset) const;
    void bindCoords(const Model& model, const MeshKey& meshKey, const CoordKey& coordKey, CoordUse use);

    VertexInput input_;
    std::map<MeshKey, MeshSlot> meshes_;
    std::map<CoordKey, CoordSlot> coords_;
    const MeshSlot* bound_ = nullptr;
};

} // namespace texplorer::render
