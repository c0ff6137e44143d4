#include "texplorer/reference/shading/vertex_stage.h"

#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"

#include <glm/common.hpp>

#include <cmath>

namespace texplorer::reference {

VertexStage::VertexStage(const Scene& scene, const PassState& pass, std::size_t model, const Mesh& mesh,
                         const glm::mat4& modelview, const glm::mat4& projection, const CornerGrid& grid)
    : scene_(scene)
    , pass_(pass)
    , model_(model)
    , material_(materialOf(scene, scene.models[model]))
    , colored_(mesh.colored)
    , eye_(modelview)
    , clip_(projection * modelview)
    , grid_(grid) {}

glm::vec4 VertexStage::clip(const Vertex& vertex) const {
    const glm::vec4 clip = clip_ * glm::vec4(vertex.position, 1);
    if (grid_.bits == 0 || clip.w == 0)
        return clip;
    // Section 2.11.1, to the window and back. What is behind the eye is snapped as well: clipping comes
    // later.
    const glm::dvec2 pixels(grid_.width, grid_.height);
    const double steps = std::ldexp(1.0, grid_.bits);
    const glm::dvec2 window = (glm::dvec2(clip) / double{clip.w} + 1.0) / 2.0 * pixels - 0.5;
    const glm::dvec2 snapped = glm::roundEven(window * steps) / steps;
    return {((snapped + 0.5) / pixels * 2.0 - 1.0) * double{clip.w}, clip.z, clip.w};
}

VertexRecord VertexStage::explain(const Vertex& vertex,
                                  const std::array<glm::vec4, maxUnits>& texCoords) const {
    VertexRecord record;
    ShadedVertex& shaded = record.shaded;
    shaded.clip = clip(vertex);
    const GenerationInputs inputs = eye_(vertex);
    record.eye = inputs.eye;
    record.normal = inputs.normal;
    const glm::vec4 current = colored_ ? vertex.color : material_.color;
    const Reflectance surface(material_, current);
    if (pass_.pass->lighting)
        record.lighting = lightingTerms(scene_.light, surface, glm::vec3(record.eye), record.normal);
    const VertexColors colors = pass_.pass->lighting
                                    ? litColors(record.lighting, surface, scene_.light.colorControl)
                                    : unlitColors(current);
    shaded.primary = colors.primary;
    shaded.secondary = colors.secondary;
    if (pass_.twoSided) { // section 2.14.1: with the normal reversed
        record.backLighting = lightingTerms(scene_.light, surface, glm::vec3(record.eye), -record.normal);
        shaded.back = litColors(record.backLighting, surface, scene_.light.colorControl);
    }
    shaded.fogDistance = std::abs(record.eye.z);
    for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
        const UnitState& unit = pass_.units[u];
        if (!unit.texture)
            continue;
        record.generated[u] = generatedCoordinates(*unit.unit, unit.flip, texCoords[u], inputs);
        shaded.texCoords[u] = unit.matrices[model_] * record.generated[u]; // section 2.11.2
    }
    return record;
}

std::array<TexCoords, maxUnits> givenTexCoords(const Scene& scene, const PassState& pass, const Model& model,
                                               const Mesh& mesh, double time) {
    std::array<TexCoords, maxUnits> lists;
    for (int u = 0; u < pass.unitsUsed; ++u)
        lists[static_cast<std::size_t>(u)] =
            texplorer::givenTexCoords(scene, *pass.pass, u, model, mesh, time);
    return lists;
}

std::vector<ShadedVertex> shadeVertices(const VertexStage& stage, const Mesh& mesh,
                                        const std::array<TexCoords, maxUnits>& lists, const PassState& pass) {
    std::vector<ShadedVertex> shaded;
    shaded.reserve(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        std::array<glm::vec4, maxUnits> coords{};
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u)
            coords[u] = lists[u][i];
        shaded.push_back(stage(mesh.vertices[i], coords));
    }
    return shaded;
}

} // namespace texplorer::reference
