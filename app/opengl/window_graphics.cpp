#include "app/opengl/window_graphics.h"

#include "app/opengl/core_graphics.h"
#include "app/opengl/opengl_graphics.h"
#include "app/render/capabilities.h"

#include <GL/glew.h>

#include <utility>

namespace texplorer::opengl {

Result<std::unique_ptr<stage::Graphics>> createWindowGraphics(render::ShaderOptions shaders,
                                                              const view::Pretence& pretence) {
    Result<std::unique_ptr<OpenGlGraphics>> whole = OpenGlGraphics::create(std::move(shaders), pretence);
    if (whole)
        return std::move(*whole);
    if (render::hasFixedFunctions())
        return fail(whole.error());
    return std::make_unique<CoreGraphics>();
}

void finishDrawing() {
    glFinish();
}

} // namespace texplorer::opengl
