#pragma once

#include "texplorer/mesh/mesh.h"
#include "texplorer/scene/scene.h"

#include <optional>

namespace texplorer {

// The vertices of a model as glBegin … glEnd sends them. glTexCoord sets the current coordinates, and
// glVertex takes what is current (OpenGL 2.1, section 2.7): a vertex whose glTexCoord is left out
// (Model::noTexCoord) has the coordinates of the vertex sent before it.
//
// Every model starts with (0, 0, 0, 1): programs set it. Without that, the coordinates of the model drawn
// before it would stay, in the first frame others than in the second.

/// Whether glTexCoord is left out for any vertex and unit. Numbers without a vertex have no effect.
[[nodiscard]] bool leavesOutCalls(const Model& model);

struct SentVertex {
    std::uint32_t vertex; ///< of the mesh
    /// For each unit, the vertex whose coordinates it has: itself, or one sent before; empty: (0, 0, 0, 1).
    std::array<std::optional<std::uint32_t>, maxUnits> coordsOf{};
};

/// The vertices in drawing order, for a mesh that of its indices: one that several parts share is sent for
/// each.
[[nodiscard]] std::vector<SentVertex> sentVertices(const Model& model, const Mesh& mesh);

/// The first one that has the coordinates of another for a unit, because its call is left out.
[[nodiscard]] std::optional<SentVertex> firstWithoutCall(const std::vector<SentVertex>& sent,
                                                         std::size_t unit);

/// By vertex, the one whose coordinates for a unit it has where it is sent first: itself if its call isn't
/// left out; empty: (0, 0, 0, 1).
[[nodiscard]] std::vector<std::optional<std::uint32_t>> coordSources(const Model& model, const Mesh& mesh,
                                                                     int unit);

/// That of one vertex.
[[nodiscard]] std::optional<std::uint32_t> coordSource(const Model& model, const Mesh& mesh, int unit,
                                                       std::size_t vertex);

/// Leaves out the call of a vertex, or sends it again.
void setLeftOut(Model& model, int unit, std::size_t vertex, bool leftOut);

/// What glBegin is given for them.
[[nodiscard]] Primitive sentPrimitive(const Model& model);

/// A model as it is drawn: if it leaves out calls, a mesh with a vertex for each that is sent and its
/// coordinates, in the order of sentVertices, and else the model itself, without a copy. Refers to the model,
/// which must outlive it.
class SentModel {
public:
    explicit SentModel(const Model& model);
    explicit SentModel(Model&&) = delete;

    [[nodiscard]] const Model& operator*() const { return made_ ? made_->model : model_; }
    [[nodiscard]] const Model* operator->() const { return &**this; }

    /// The vertex of the given model that one of this model is.
    [[nodiscard]] std::uint32_t vertexOf(std::uint32_t drawn) const {
        return made_ ? made_->sent[drawn].vertex : drawn;
    }
    /// The one whose coordinates for a unit it has; empty: (0, 0, 0, 1).
    [[nodiscard]] std::optional<std::uint32_t> coordsOf(std::uint32_t drawn, std::size_t unit) const {
        return made_ ? made_->sent[drawn].coordsOf[unit] : drawn;
    }
    /// The mesh of the given model if this one is another; else nullptr.
    [[nodiscard]] const Mesh* givenMesh() const { return made_ ? &made_->given : nullptr; }

private:
    struct Made {
        Model model;
        Mesh given;
        std::vector<SentVertex> sent;
    };

    const Model& model_;
    std::optional<Made> made_;
};

} // namespace texplorer
