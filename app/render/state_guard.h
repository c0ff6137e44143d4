#pragma once

#include <GL/glew.h>
#include <glm/mat4x4.hpp>

#include <vector>

namespace texplorer::render {

/// Saves the whole state of the context, sets everything that fixed-function drawing depends on to GL's
/// initial values, and restores the state in the destructor. Texture objects, buffers and framebuffers that
/// are made or changed in between are not restored.
class StateGuard {
public:
    StateGuard();
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

private:
    struct UnitState {
        GLint texture1D = 0;
        GLint texture2D = 0;
        GLint texture3D = 0;
        GLint textureCube = 0;
        GLint sampler = 0;
        glm::mat4 matrix{1};
    };

    void save();
    void unbind();
    void setInitialValues() const;

    GLint program_ = 0;
    GLint vertexArray_ = 0;
    GLint drawFramebuffer_ = 0;
    GLint readFramebuffer_ = 0;
    GLint renderbuffer_ = 0;
    GLint arrayBuffer_ = 0;
    GLint packBuffer_ = 0;
    GLint unpackBuffer_ = 0;
    GLint activeTexture_ = GL_TEXTURE0;
    GLint clientActiveTexture_ = GL_TEXTURE0;
    GLint provokingVertex_ = 0;
    bool colorSum_ = false;
    GLint fogSource_ = 0;
    bool seamless_ = false; // cube maps
    glm::mat4 projection_{1};
    glm::mat4 modelView_{1};
    std::vector<UnitState> units_; // of the fixed-function pipeline
    bool pushed_ = false;
    bool clientPushed_ = false;
};

} // namespace texplorer::render
