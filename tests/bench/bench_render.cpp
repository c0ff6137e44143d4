// A frame of the default scene against a bare loop: the same geometry and the same state, set once, and
// nothing but the clear, the matrices and the draw calls in every frame. Both draw the same picture, or the
// benchmark fails.

#include "app/offscreen/context.h"
#include "app/render/fixed_renderer.h"
#include "app/render/shader_renderer.h"
#include "core/image/mipmaps.h"
#include "core/mesh/mesh.h"
#include "core/s3tc/surface_pixels.h"
#include "core/scene/animation.h"
#include "core/scene/model_mesh.h"
#include "core/texture/image_source.h"

#include <GL/glew.h>
#include <benchmark/benchmark.h>
#include <glm/gtc/type_ptr.hpp>

#include <cstddef>
#include <vector>

namespace texplorer::bench {
namespace {

view::Size sizeOf(const benchmark::State& state) {
    return {static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
}

const void* offsetInBuffer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

/// The default scene, written out by hand. Leaks its GL objects to the end of the context.
class BareLoop {
public:
    explicit BareLoop(view::Size size)
        : size_(size)
        , scene_(defaultScene()) {
        makeFramebuffer();
        makeTexture();
        for (const Model& model : scene_.models)
            makeModel(model);
        setState();
    }

    void draw() const {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const glm::mat4 view = viewMatrix(scene_.view);
        for (std::size_t i = 0; i < models_.size(); ++i) {
            glLoadMatrixf(glm::value_ptr(view * modelMatrix(scene_.models[i], 0)));
            glBindBuffer(GL_ARRAY_BUFFER, models_[i].vertices);
            glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, models_[i].triangles);
            glVertexPointer(3, GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, position)));
            glNormalPointer(GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, normal)));
            glTexCoordPointer(4, GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, texCoord)));
            glDrawElements(GL_TRIANGLES, models_[i].count, GL_UNSIGNED_INT, nullptr);
        }
    }

    [[nodiscard]] Image read() const {
        Image image = Image::uninitialised(PixelFormat::Rgba8, size_.width, size_.height);
        glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
        return image;
    }

private:
    struct Buffers {
        GLuint vertices = 0;
        GLuint triangles = 0;
        GLsizei count = 0;
    };

    void makeFramebuffer() const {
        GLuint color = 0;
        GLuint depth = 0;
        GLuint framebuffer = 0;
        glGenTextures(1, &color);
        glBindTexture(GL_TEXTURE_2D, color);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_.width, size_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glGenRenderbuffers(1, &depth);
        glBindRenderbuffer(GL_RENDERBUFFER, depth);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_.width, size_.height);
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
        glViewport(0, 0, size_.width, size_.height);
    }

    void makeTexture() const {
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        const MipChain chain = buildMipChain(uprightImage(*ImageSource().find(scene_.textures[0])));
        for (std::size_t level = 0; level < chain.size(); ++level)
            glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA8, chain[level].width,
                         chain[level].height, 0, GL_RGBA, GL_UNSIGNED_BYTE, chain[level].pixels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glEnable(GL_TEXTURE_2D);
    }

    void makeModel(const Model& model) {
        const Mesh mesh = meshOf(model);
        Buffers& buffers = models_.emplace_back();
        buffers.count = static_cast<GLsizei>(mesh.triangles.size());
        glGenBuffers(1, &buffers.vertices);
        glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                     mesh.vertices.data(), GL_STATIC_DRAW);
        glGenBuffers(1, &buffers.triangles);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.triangles);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])),
                     mesh.triangles.data(), GL_STATIC_DRAW);
    }

    void setState() const {
        const glm::vec4& background = scene_.view.background;
        glClearColor(background.r, background.g, background.b, background.a);
        glDisable(GL_DITHER);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glEnable(GL_NORMALIZE);
        glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(scene_.light.position));
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, glm::value_ptr(scene_.material.specular));
        glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, scene_.material.shininess);
        glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
        glEnable(GL_COLOR_MATERIAL);
        for (const GLenum array :
             {unsigned{GL_VERTEX_ARRAY}, unsigned{GL_NORMAL_ARRAY}, unsigned{GL_TEXTURE_COORD_ARRAY}})
            glEnableClientState(array);
        const float aspect = static_cast<float>(size_.width) / static_cast<float>(size_.height);
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixf(glm::value_ptr(projectionMatrix(scene_.view, aspect)));
        glMatrixMode(GL_MODELVIEW);
    }

    view::Size size_;
    Scene scene_;
    std::vector<Buffers> models_;
};

/// What the two benchmarks share: a context, and the renderer whose picture is the right one.
struct Stage {
    Result<offscreen::Context> context = offscreen::Context::create({1, 1});
    Result<render::FixedRenderer> renderer =
        render::loadCapabilities().and_then(&render::FixedRenderer::create);
    ImageSource images;
};

void drawFrames(benchmark::State& state, const ImageSource& images, auto& renderer) {
    if (!renderer)
        return state.SkipWithError(describe(renderer.error()).c_str());
    const Scene scene = defaultScene();
    const view::Size size = sizeOf(state);
    for (auto _ : state) {
        const auto drawn = renderer->draw(scene, images, 0, size);
        if (!drawn || !drawn->problems.empty())
            return state.SkipWithError("the default scene can't be drawn");
        glFinish();
    }
}

void frame(benchmark::State& state) {
    Stage stage;
    drawFrames(state, stage.images, stage.renderer);
}

/// The same with GLSL.
void frameShader(benchmark::State& state) {
    const Stage stage;
    Result<render::ShaderRenderer> renderer = render::loadCapabilities().and_then(
        [](const view::Capabilities& capabilities) { return render::ShaderRenderer::create(capabilities); });
    drawFrames(state, stage.images, renderer);
}

void frameBare(benchmark::State& state) {
    Stage stage;
    if (!stage.renderer)
        return state.SkipWithError(describe(stage.renderer.error()).c_str());
    const BareLoop bare(sizeOf(state));
    bare.draw();
    const auto drawn = stage.renderer->draw(defaultScene(), stage.images, 0, sizeOf(state));
    const auto expected = stage.renderer->read();
    if (!drawn || !expected || bare.read() != *expected)
        return state.SkipWithError("the bare loop draws another picture");
    for (auto _ : state) {
        bare.draw();
        glFinish();
    }
}

BENCHMARK(frame)->Args({640, 480})->Args({1280, 800})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(frameShader)->Args({640, 480})->Args({1280, 800})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(frameBare)->Args({640, 480})->Args({1280, 800})->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace texplorer::bench
