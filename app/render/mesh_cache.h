#pragma once

#include "app/render/gl_handle.h"
#include "core/mesh/mesh.h"
#include "core/scene/scene.h"

#include <compare>
#include <cstdint>
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

    /// Points the vertex arrays at the model with this index in the scene, as a pass of it draws it at a
    /// time. `units` says what each texture unit needs.
    void bind(const Scene& scene, const Pass& pass, std::size_t index, double time,
              const std::array<CoordUse, maxUnits>& units);

    /// Whether the model that is bound has colours at its vertices.
    [[nodiscard]] bool hasColors() const { return bound_ && bound_->mesh.colored; }

    /// Draws the model that is bound.
    void draw() const;

private:
    struct MeshKey {
        ShapeOptions shape{};
        std::size_t owner = 0;                            ///< of a mesh of its own: the model's index
        auto operator<=>(const MeshKey&) const = default; // NOLINT(modernize-use-nullptr): there is none
    };
    struct MeshSlot {
        MeshData data{}; ///< of a mesh of its own
        Mesh mesh;
        std::uint64_t version = 0;
        BufferHandle vertices;
        BufferHandle indices; ///< of triangles, then lines, then points
        bool used = true;
    };
    struct CoordKey {
        std::size_t model = 0;
        int unit = 0;
        bool embossed = false;
        auto operator<=>(const CoordKey&) const = default; // NOLINT(modernize-use-nullptr)
    };
    struct CoordSlot {
        TexCoords list; ///< the model's, or as they were embossed
        std::uint64_t mesh = 0;
        CoordUse use = CoordUse::AsGiven;
        BufferHandle buffer;
        bool used = true;
    };

    static MeshKey keyOf(const Model& model, std::size_t index);
    MeshSlot& meshOf(const Model& model, std::size_t index);
    void pointAtVertices() const;
    void pointAtCoords(int unit, int stride, std::size_t offset) const;
    void bindCoords(const Scene& scene, const Pass& pass, double time, const CoordKey& coordKey,
                    CoordUse use);

    VertexInput input_;
    std::map<MeshKey, MeshSlot> meshes_;
    std::map<CoordKey, CoordSlot> coords_;
    const MeshSlot* bound_ = nullptr;
    std::uint64_t versions_ = 0;
};

} // namespace texplorer::render
