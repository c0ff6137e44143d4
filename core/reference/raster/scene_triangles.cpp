#include "texplorer/reference/raster/scene_triangles.h"

#include "texplorer/reference/raster/assembly.h"
#include "texplorer/reference/shading/vertex_stage.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"

namespace texplorer::reference {

void eachTriangle(const Scene& scene, std::span<const PassState> passes, double time, Viewport viewport,
                  const std::stop_token& stop, const std::function<void(const Triangle&)>& work) {
    const glm::mat4 projection = projectionMatrix(scene.view, static_cast<float>(viewport.width) /
                                                                  static_cast<float>(viewport.height));
    for (const PassState& pass : passes) {
        for (const std::size_t index : drawnModels(scene, *pass.pass)) {
            const SentModel sent(scene.models[index]);
            const Model& model = *sent;
            const Mesh mesh = meshOf(model);
            const VertexStage stage(scene, pass, index, mesh, modelViewMatrix(scene.view, model, time),
                                    projection, {viewport.width, viewport.height, viewport.cornerBits});
            const std::vector<ShadedVertex> vertices =
                shadeVertices(stage, mesh, givenTexCoords(scene, pass, model, mesh, time), pass);
            const Assembly assembly(pass, model, viewport, work);
            for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
                if (stop.stop_requested())
                    return;
                assembly.add(vertices[mesh.triangles[i]], vertices[mesh.triangles[i + 1]],
                             vertices[mesh.triangles[i + 2]]);
            }
            for (std::size_t i = 0; i + 1 < mesh.lines.size(); i += 2) {
                if (stop.stop_requested())
                    return;
                assembly.add(vertices[mesh.lines[i]], vertices[mesh.lines[i + 1]]);
            }
            for (const std::uint32_t point : mesh.points) {
                if (stop.stop_requested())
                    return;
                assembly.add(vertices[point]);
            }
        }
    }
}

} // namespace texplorer::reference
