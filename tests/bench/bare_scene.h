#pragma once

// The default scene in plain calls of OpenGL, as a program for this scene alone makes them: state set once,
// then nothing but the clear, the matrices and the draw calls in every frame.

#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"

#include <vector>

namespace texplorer::bench {

/// Draws in the current context, into a framebuffer object of its own. Its objects of OpenGL live as long as
/// the context.
class BareScene {
public:
    BareScene(int width, int height);

    void draw() const;

    /// Rgba8, the bottom row first, as glReadPixels gives it.
    [[nodiscard]] Image read() const;

private:
    struct Buffers {
        unsigned vertices = 0;
        unsigned triangles = 0;
        int count = 0;
    };

    [[nodiscard]] static Buffers makeModel(const Model& model);
    void makeFramebuffer() const;
    void makeTexture() const;
    void setState() const;
    void placeModel(const Model& model) const;

    int width_;
    int height_;
    Scene scene_ = defaultScene();
    std::vector<Buffers> models_;
};

} // namespace texplorer::bench
