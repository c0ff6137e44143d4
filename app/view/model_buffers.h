#pragma once

#include "texplorer/mesh/mesh.h"
#include "texplorer/scene/scene.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <utility>

namespace texplorer::view {

/// The texture coordinates that a unit needs.
enum class CoordUse : std::uint8_t {
    Off,
    AsGiven,
    Flipped, ///< t becomes q - t, so that t / q becomes 1 - t / q
};

/// A buffer of vertices or indices; freed with the last owner.
using Buffer = std::shared_ptr<const unsigned>;
enum class BufferKind : std::uint8_t { Vertices, Indices };
using MakeBuffer = std::function<Buffer(BufferKind, std::span<const std::byte>)>;

/// The vertex and index buffers of a scene's models, made by the caller's function. Filled again when a shape or a
/// texture coordinate changes.
class ModelBuffers {
public:
    explicit ModelBuffers(MakeBuffer make)
        : make_(std::move(make)) {}

    /// Coordinates of a unit: four floats each.
    struct Coords {
        const Buffer* buffer = nullptr; ///< nullptr: the unit needs none
        int stride = 0;                 ///< in bytes; 0: packed
        std::size_t offset = 0;         ///< in bytes
    };
    /// The buffers of a model.
    struct Bound {
        const Mesh* mesh = nullptr;
        const Buffer* vertices = nullptr; ///< of Vertex
        const Buffer* indices = nullptr;  ///< 32 bits: of triangles, then lines, then points
        std::array<Coords, maxUnits> coords{};
    };

    /// Starts a frame: removes models that the previous frame did not draw.
    void beginFrame();

    /// Returns the buffers of the model with this index in the scene, for a pass at a time; valid until the
    /// next call. `units` gives the coordinates that each texture unit needs.
    [[nodiscard]] Bound of(const Scene& scene, const Pass& pass, std::size_t index, double time,
                           const std::array<CoordUse, maxUnits>& units);

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
        Buffer vertices;
        Buffer indices;
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
        Buffer buffer;
        bool used = true;
    };

    static MeshKey keyOf(const Model& model, std::size_t index);
    /// The model with a vertex for each that is sent, if it leaves out calls of glTexCoord.
    const Model& sentModel(const Model& model, std::size_t index);
    MeshSlot& meshOf(const Model& model, std::size_t index);
    Coords coordsOf(const Scene& scene, const Pass& pass, const Model& model, double time,
                    const MeshSlot& mesh, const CoordKey& coordKey, CoordUse use);

    MakeBuffer make_;
    std::map<MeshKey, MeshSlot> meshes_;
    std::map<CoordKey, CoordSlot> coords_;
    std::map<std::size_t, std::pair<Model, Model>> sent_; ///< by model: as given, and as sent
    std::uint64_t versions_ = 0;
};

} // namespace texplorer::view
