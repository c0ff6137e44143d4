#include "core/reference/raster/scene_triangles.h"

#include "core/mesh/mesh.h"
#include "core/reference/shading/vertex_stage.h"
#include "core/scene/animation.h"

namespace texplorer::reference {

namespace {

class Assembly {
public:
    Assembly(const PassState& pass, Viewport viewport, const std::function<void(const Triangle&)>& work)
        : pass_(pass)
        , viewport_(viewport)
        , work_(work) {}

    void add(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const {
        if (pass_.flat) // section 2.14.7: the colours of the last vertex
            addClipped(withColorsOf(c, a), withColorsOf(c, b), c);
        else
            addClipped(a, b, c);
    }

private:
    static ShadedVertex withColorsOf(const ShadedVertex& colored, ShadedVertex vertex) {
        vertex.primary = colored.primary;
        vertex.secondary = colored.secondary;
        return vertex;
    }

    void addClipped(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const {
        if (isInside(a, b, c))
            return addTriangle(a, b, c);
        const Polygon polygon = clip(a, b, c, pass_.perspective);
        for (std::size_t i = 2; i < polygon.size(); ++i)
            addTriangle(polygon[0], polygon[i - 1], polygon[i]);
    }

    void addTriangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const {
        if (const auto triangle = setUp(a, b, c, pass_, viewport_, pass_.perspective))
            work_(*triangle);
    }

    const PassState& pass_;
    Viewport viewport_;
    const std::function<void(const Triangle&)>& work_;
};

} // namespace

void eachTriangle(const Scene& scene, std::span<const PassState> passes, double time, Viewport viewport,
                  const std::stop_token& stop, const std::function<void(const Triangle&)>& work) {
    const glm::mat4 view = viewMatrix(scene.view);
    const glm::mat4 projection = projectionMatrix(scene.view, static_cast<float>(viewport.width) /
                                                                  static_cast<float>(viewport.height));
    for (const PassState& pass : passes) {
        if (!pass.pass->enabled)
            continue;
        const Assembly assembly(pass, viewport, work);
        for (const Model& model : scene.models) {
            if (!model.visible)
                continue;
            const Mesh mesh = makeMesh(model.shape, model.slices, model.stacks);
            const VertexStage stage(scene, pass, view * modelMatrix(model, time), projection);
            const std::vector<ShadedVertex> vertices = shadeVertices(stage, model, mesh, pass);
            for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
                if (stop.stop_requested())
                    return;
                assembly.add(vertices[mesh.triangles[i]], vertices[mesh.triangles[i + 1]],
                             vertices[mesh.triangles[i + 2]]);
            }
        }
    }
}

} // namespace texplorer::reference
