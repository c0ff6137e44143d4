#pragma once

#include "texplorer/mesh/mesh.h"
#include "texplorer/reference/shading/coordinates.h"
#include "texplorer/reference/shading/lighting.h"
#include "texplorer/reference/shading/pass_state.h"
#include "texplorer/reference/shading/vertex.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace texplorer::reference {

/// A vertex with all intermediate values.
struct VertexRecord {
    glm::vec4 eye{0, 0, 0, 1};
    glm::vec3 normal{0};                         ///< in eye coordinates, of unit length
    LightingTerms lighting{};                    ///< if the pass is lit
    LightingTerms backLighting{};                ///< the same for back faces, with two-sided lighting
    std::array<glm::vec4, maxUnits> generated{}; ///< coordinates before the texture matrix
    ShadedVertex shaded;
};

/// The grid of corner positions: for a driver that has `bits` of GL_SUBPIXEL_BITS and computes everything
/// from snapped corners, in a picture of this size. 0 bits: no grid.
struct CornerGrid {
    int width = 1;
    int height = 1;
    int bits = 0;
};

/// Transforms and lights the vertices of a model: clip coordinates, colours and generated coordinates.
/// `modelview` and `projection` as in section 2.11.
class VertexStage {
public:
    /// `model` is the index of one of the scene's.
    VertexStage(const Scene& scene, const PassState& pass, std::size_t model, const Mesh& mesh,
                const glm::mat4& modelview, const glm::mat4& projection, const CornerGrid& grid);

    /// `texCoords` has one coordinate per unit, as given by the scene.
    [[nodiscard]] ShadedVertex operator()(const Vertex& vertex,
                                          const std::array<glm::vec4, maxUnits>& texCoords) const {
        return explain(vertex, texCoords).shaded;
    }

    [[nodiscard]] VertexRecord explain(const Vertex& vertex,
                                       const std::array<glm::vec4, maxUnits>& texCoords) const;

    /// Only the clip coordinates.
    [[nodiscard]] glm::vec4 clip(const Vertex& vertex) const;

private:
    const Scene& scene_;
    const PassState& pass_;
    std::size_t model_;
    const Material& material_;
    bool colored_; ///< a vertex's colour replaces glColor
    EyeSpace eye_;
    glm::mat4 clip_;
    CornerGrid grid_;
};

/// The coordinates of a model's vertices, a list for each unit that a pass uses.
[[nodiscard]] std::array<TexCoords, maxUnits>
givenTexCoords(const Scene& scene, const PassState& pass, const Model& model, const Mesh& mesh, double time);

/// All vertices of a model in a pass.
[[nodiscard]] std::vector<ShadedVertex> shadeVertices(const VertexStage& stage, const Mesh& mesh,
                                                      const std::array<TexCoords, maxUnits>& lists,
                                                      const PassState& pass);

} // namespace texplorer::reference
