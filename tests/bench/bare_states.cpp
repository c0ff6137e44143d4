// The peer of many shots in one call: the same 36 pictures drawn and read back in one OSMesa context by plain
// OpenGL, nothing encoded and nothing written. With a folder, what was read is left there, NUMBER.rgba.

#include "core/base/file_io.h"
#include "core/image/mipmaps.h"
#include "core/s3tc/surface_pixels.h"
#include "core/scene/animation.h"
#include "core/scene/model_mesh.h"
#include "core/texture/image_source.h"
#include "tests/bench/shot_states.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <glm/gtc/type_ptr.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace texplorer;

const void* offsetInBuffer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr): OpenGL wants one
}

void makeFramebuffer(int extent) {
    GLuint color = 0;
    GLuint depth = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &color);
    glBindTexture(GL_TEXTURE_2D, color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, extent, extent, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, extent, extent);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glViewport(0, 0, extent, extent);
}

void makeTexture(const Scene& scene) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    const MipChain chain = buildMipChain(uprightImage(*ImageSource().find(scene.textures[0])));
    for (std::size_t level = 0; level < chain.size(); ++level)
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA8, chain[level].width,
                     chain[level].height, 0, GL_RGBA, GL_UNSIGNED_BYTE, chain[level].pixels.data());
    glEnable(GL_TEXTURE_2D);
}

struct Buffers {
    GLuint vertices = 0;
    GLuint triangles = 0;
    GLsizei count = 0;
};

Buffers makeModel(const Model& model) {
    const Mesh mesh = meshOf(model);
    Buffers buffers;
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
    return buffers;
}

void setState(const Scene& scene) {
    const glm::vec4& background = scene.view.background;
    glClearColor(background.r, background.g, background.b, background.a);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(scene.light.position));
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, glm::value_ptr(scene.material.specular));
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, scene.material.shininess);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(scene.passes[0].units[0].envColor));
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(projectionMatrix(scene.view, 1)));
    glMatrixMode(GL_MODELVIEW);
}

void draw(const Scene& scene, const std::vector<Buffers>& models) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 view = viewMatrix(scene.view);
    for (std::size_t i = 0; i < models.size(); ++i) {
        glLoadMatrixf(glm::value_ptr(view * modelMatrix(scene.models[i], 0)));
        glBindBuffer(GL_ARRAY_BUFFER, models[i].vertices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, models[i].triangles);
        glVertexPointer(3, GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, position)));
        glNormalPointer(GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, normal)));
        glTexCoordPointer(4, GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, texCoord)));
        glDrawElements(GL_TRIANGLES, models[i].count, GL_UNSIGNED_INT, nullptr);
    }
}

} // namespace

int main(int argc, char** argv) {
    constexpr int extent = bench::statesExtent;
    std::vector<std::byte> unseen(4);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    if (!context || !OSMesaMakeCurrent(context, unseen.data(), GL_UNSIGNED_BYTE, 1, 1))
        return 1;
    const Scene scene = defaultScene();
    makeFramebuffer(extent);
    makeTexture(scene);
    std::vector<Buffers> models;
    for (const Model& model : scene.models)
        models.push_back(makeModel(model));
    setState(scene);

    bool good = true;
    int number = 0;
    std::vector<std::byte> pixels(std::size_t{4} * extent * extent);
    bench::eachState([&](const EnumRow& filter, const EnumRow& mode) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter.value));
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode.value));
        draw(scene, models);
        glReadPixels(0, 0, extent, extent, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        const std::string name = std::to_string(++number) + ".rgba";
        if (argc > 1 && !writeFileAtomically(std::filesystem::path(argv[1]) / name, pixels))
            good = false;
    });
    good = good && glGetError() == GL_NO_ERROR;
    OSMesaDestroyContext(context);
    return good ? 0 : 1;
}
