#pragma once

#include "app/render/gl_errors.h"
#include "app/render/mesh_cache.h"
#include "app/render/texture_cache.h"
#include "app/view/frame.h"
#include "core/scene/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace texplorer::render {

/// One texture a unit; name 0 where a unit is off or its texture can't be drawn.
using BoundTextures = std::array<BoundTexture, maxUnits>;

/// How state reaches GL: what the renderers that draw with OpenGL do differently. Its functions are called in
/// this order, with GL's initial state (see StateGuard) at the beginning of a frame.
class Pipeline {
public:
    Pipeline() = default;
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;
    virtual ~Pipeline() = default;

    /// Which vertex arrays it reads.
    [[nodiscard]] virtual VertexInput vertexInput() const = 0;

    /// What is the same for all passes; `aspect` is width / height of the picture.
    virtual void beginFrame(const Scene& scene, float aspect, GlErrors& errors) = 0;

    /// Everything that a pass says but its depth test and blending. False where it can't be drawn, which is
    /// said in `errors`.
    [[nodiscard]] virtual bool beginPass(const Scene& scene, std::size_t pass, const BoundTextures& textures,
                                         double time, GlErrors& errors) = 0;

    /// Those of the frame that is drawn, one a pass; empty where it has none.
    [[nodiscard]] virtual std::vector<std::shared_ptr<const view::PassShader>> shaders() const { return {}; }

    /// Grows when it draws the same scene otherwise than before: somebody has edited its shaders.
    [[nodiscard]] virtual std::uint64_t revision() const { return 0; }

    /// Before each model. `colored` says that its vertices have colours in the place of glColor.
    virtual void placeModel(const Scene& scene, const Model& model, bool colored, double time) = 0;
};

} // namespace texplorer::render
