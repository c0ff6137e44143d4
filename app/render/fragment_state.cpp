#include "app/render/fragment_state.h"

#include <GL/glew.h>

namespace texplorer::render {

void applyDepthAndBlend(const Pass& pass) {
    (pass.depthTest ? glEnable : glDisable)(GL_DEPTH_TEST);
    glDepthFunc(static_cast<GLenum>(pass.depthFunc));
    (pass.blend ? glEnable : glDisable)(GL_BLEND);
    glBlendFunc(static_cast<GLenum>(pass.blendSrc), static_cast<GLenum>(pass.blendDst));
}

void applyLineAndPoint(const Model& model) {
    glLineWidth(model.lineWidth);
    glPointSize(model.pointSize);
}

} // namespace texplorer::render
