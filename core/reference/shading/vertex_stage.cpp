#include "core/reference/shading/vertex_stage.h"

#include "core/scene/emboss.h"
#include "core/scene/model_mesh.h"

#include <cmath>

namespace texplorer::reference {

VertexStage::VertexStage(const Scene& scene, const PassState& pass, const Model& model, const Mesh& mesh,
                         const glm::mat4& modelview, const glm::mat4& projection)
    : scene_(scene)
    , pass_(pass)
    , material_(materialOf(scene, model))
    , colored_(mesh.colored)
    , eye_(modelview)
    , clip_(projection * modelview) {}

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
        shaded.texCoords[u] = unit.matrix * record.generated[u]; // section 2.11.2
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
