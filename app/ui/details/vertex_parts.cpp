#include "app/ui/details/vertices_tab.h"
#include "app/ui/model/tex_coord_edits.h"
#include "texplorer/scene/mesh_edits.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

namespace texplorer::ui {

std::string meshPath(const Session& session, const std::string& key) {
    return fmt::format("{}.{}.{}",
                       elementOf<&Scene::models>(static_cast<std::size_t>(session.look.selection.model)),
                       keyOf<&Model::mesh>(), key);
}

const VertexPartRow& rowOf(VertexPart part) {
    static const std::array rows{
        VertexPartRow{VertexPart::Coordinates,
                      N_("Coordinates"),
                      {"s", "t", "r", "q"},
                      4,
                      coordRange,
                      coordsPath,
                      nullptr,
                      nullptr,
                      N_("Move vertex {0}"),
                      N_("The place of each vertex in the image")},
        VertexPartRow{VertexPart::Position,
                      N_("Position"),
                      {"x", "y", "z", ""},
                      3,
                      {-1000, 1000, 0.01F, {}},
                      [](const Session& session) { return meshPath(session, keyOf<&MeshData::positions>()); },
                      [](const Scene&, const Model& model, std::size_t vertex) {
                          return glm::vec4(model.mesh.positions[vertex], 1);
                      },
                      [](const Scene&, Model& model, std::size_t vertex, glm::vec4 value, bool together) {
                          setPosition(model.mesh, vertex, glm::vec3(value), together);
                      },
                      N_("Position of vertex {0}"),
                      N_("glVertex3f: the position of each vertex in the model")},
        VertexPartRow{VertexPart::Normal,
                      N_("Normal"),
                      {"x", "y", "z", ""},
                      3,
                      {-1, 1, 0.005F, {}},
                      [](const Session& session) { return meshPath(session, keyOf<&MeshData::normals>()); },
                      [](const Scene&, const Model& model, std::size_t vertex) {
                          return glm::vec4(givenNormal(model.mesh, vertex), 0);
                      },
                      [](const Scene&, Model& model, std::size_t vertex, glm::vec4 value, bool) {
                          setNormal(model.mesh, vertex, glm::vec3(value));
                      },
                      N_("Normal of vertex {0}"),
                      N_("glNormal3f: the direction of the surface at each vertex, normalized to length 1")},
        VertexPartRow{VertexPart::Color,
                      N_("Colour"),
                      {"r", "g", "b", "a"},
                      4,
                      {0, 1, 0.005F, {}},
                      [](const Session& session) { return meshPath(session, keyOf<&MeshData::colors>()); },
                      [](const Scene& scene, const Model& model, std::size_t vertex) {
                          const MeshData& mesh = model.mesh;
                          return mesh.colors.size() == mesh.positions.size() ? mesh.colors[vertex]
                                                                             : materialOf(scene, model).color;
                      },
                      [](const Scene& scene, Model& model, std::size_t vertex, glm::vec4 value, bool) {
                          setColor(model.mesh, vertex, value, materialOf(scene, model).color);
                      },
                      N_("Colour of vertex {0}"),
                      N_("glColor4f: the colour of each vertex, instead of the material's")},
    };
    return rows.at(static_cast<std::size_t>(part));
}

} // namespace texplorer::ui
