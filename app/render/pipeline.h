#pragma once

#include "app/render/gl_errors.h"
#include "app/render/mesh_cache.h"
#include "app/render/texture_cache.h"
#include "app/view/frame.h"
#include "texplorer/scene/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace texplorer::render {

/// One texture per unit; the name is 0 if a unit is off or its texture cannot be drawn.
using BoundTextures = std::array<BoundTexture, maxUnits>;

/// How state is sent to GL: the difference between the OpenGL renderers. A frame calls the functions in this
/// order and starts with GL's initial state (see StateGuard).
class Pipeline {
public:
    Pipeline() = default;
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;
    virtual ~Pipeline() = default;

    /// The vertex arrays that it reads.
    [[nodiscard]] virtual VertexInput vertexInput() const = 0;

    /// Sets the state that all passes share; `aspect` is width / height of the picture.
    virtual void beginFrame(const Scene& scene, float aspect, GlErrors& errors) = 0;

    /// Sets all of a pass except its depth test and blending. Returns false if it cannot be drawn; `errors`
    /// says why.
    [[nodiscard]] virtual bool beginPass(const Scene& scene, std::size_t pass, const BoundTextures& textures,
                                         double time, GlErrors& errors) = 0;

    /// The shader programs of the current frame, one per pass; empty if it has none.
    [[nodiscard]] virtual std::vector<std::shared_ptr<const view::PassShader>> shaders() const { return {}; }

    /// Increases when it draws the same scene differently: its shaders were edited.
    [[nodiscard]] virtual std::uint64_t revision() const { return 0; }

    /// Called before and after a model, the `model`th of the scene, is drawn. `colored`: its vertices have
    /// colours, which replace glColor.
    virtual void beginModel(const Scene& scene, std::size_t pass, std::size_t model, bool colored,
                            double time) = 0;
    virtual void endModel() {}

    /// Called after the models of a pass.
    virtual void endPass() {}
};

} // namespace texplorer::render
