#include "tests/bench/bare_scene.h"

#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/texture/image_source.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstddef>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace texplorer::bench {
namespace {

const void* offsetInBuffer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr): OpenGL wants one
}

} // namespace

BareScene::BareScene(int width, int height)
    : width_(width)
    , height_(height) {
    makeFramebuffer();
    makeTexture();
    for (const Model& model : scene_.models)
        models_.push_back(makeModel(model));
    setState();
}

void BareScene::draw() const {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < models_.size(); ++i) {
        placeModel(scene_.models[i]);
        glBindBuffer(GL_ARRAY_BUFFER, models_[i].vertices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, models_[i].triangles);
        glVertexPointer(3, GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, position)));
        glNormalPointer(GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, normal)));
        glTexCoordPointer(4, GL_FLOAT, sizeof(Vertex), offsetInBuffer(offsetof(Vertex, texCoord)));
        glDrawElements(GL_TRIANGLES, models_[i].count, GL_UNSIGNED_INT, nullptr);
    }
}

Image BareScene::read() const {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width_, height_);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

void BareScene::makeFramebuffer() const {
    GLuint color = 0;
    GLuint depth = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &color);
    glBindTexture(GL_TEXTURE_2D, color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width_, height_);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glViewport(0, 0, width_, height_);
}

void BareScene::makeTexture() const {
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

BareScene::Buffers BareScene::makeModel(const Model& model) {
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

void BareScene::setState() const {
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
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(scene_.passes[0].units[0].envColor));
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    const auto [near, far] = clipPlanes(scene_.view);
    const double top = near * std::tan(glm::radians(double{scene_.view.fieldOfView}) / 2);
    const double right = top * double{static_cast<float>(width_) / static_cast<float>(height_)};
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-right, right, -top, top, near, far);
    glMatrixMode(GL_MODELVIEW);
}

void BareScene::placeModel(const Model& model) const {
    glLoadIdentity();
    glTranslatef(0, 0, -scene_.view.distance);
    glRotatef(scene_.view.elevation, 1, 0, 0);
    glRotatef(-scene_.view.azimuth, 0, 1, 0);
    glTranslatef(model.position.x, model.position.y, model.position.z);
    if (model.size != 1) // OpenGL normalises by another path once something is scaled
        glScalef(model.size, model.size, model.size);
}

} // namespace texplorer::bench
