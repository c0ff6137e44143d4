#pragma once

#include "app/render/gl_handle.h"
#include "texplorer/mesh/mesh.h"
#include "texplorer/scene/scene.h"

#include <compare>
#include <cstdint>
#include <map>
#include <utility>

namespace texplorer::render {

/// The texture coordinates that a unit needs.
enum class CoordUse : std::uint8_t {
    Off,
    AsGiven,
    Flipped, ///< t becomes q - t, so that t / q becomes 1 - t / q
};

/// The destination of vertices: the fixed-function arrays (glVertexPointer and similar calls) or the
/// attributes of a shader.
enum class VertexInput : std::uint8_t { FixedArrays, Attributes };

/// The vertex and index buffers of a scene's models. Filled again when a shape or a texture coordinate
/// changes.
class MeshCache {
public:
    explicit MeshCache(VertexInput input = VertexInput::FixedArrays)
        : input_(input) {}

    /// Starts a frame: removes models that the previous frame did not draw.
    void beginFrame();

    /// Sets the vertex arrays to the model with this index in the scene, for a pass at a time. `units` gives
    /// the coordinates that each texture unit needs.
    void bind(const Scene& scene, const Pass& pass, std::size_t index, double time,
              const std::array<CoordUse, maxUnits>& units);

    /// Whether the bound model has vertex colours.
    [[nodiscard]] bool hasColors() const { return bound_ && bound_->mesh.colored; }

    /// Draws the bound model.
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
        SharedList<glm::vec4> list; ///< the coordinates of the model, or the embossed ones
        std::uint64_t mesh = 0;
        CoordUse use = CoordUse::AsGiven;
        BufferHandle buffer;
        bool used = true;
    };

    static MeshKey keyOf(const Model& model, std::size_t index);
    /// The model with a vertex for each that is sent, if it leaves out calls of glTexCoord.
    const Model& sentModel(const Model& model, std::size_t index);
    MeshSlot& meshOf(const Model& model, std::size_t index);
    void pointAtVertices() const;
    void pointAtCoords(int unit, int stride, std::size_t offset) const;
    void bindCoords(const Scene& scene, const Pass& pass, const Model& model, double time,
                    const CoordKey& coordKey, CoordUse use);

    VertexInput input_;
    std::map<MeshKey, MeshSlot> meshes_;
    std::map<CoordKey, CoordSlot> coords_;
    std::map<std::size_t, std::pair<Model, Model>> sent_; ///< by model: as given, and as sent
    const MeshSlot* bound_ = nullptr;
    std::uint64_t versions_ = 0;
};

} // namespace texplorer::render
