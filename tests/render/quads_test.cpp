// Compares the shapes with the drawing of OpenGL 1.1 programs: sphere, cylinder and disks with GLU's
// quadrics, cube, square and floor as a list of GL_QUADS. Our triangles match the driver's division of
// quadrilaterals pixel by pixel.

#include "app/render/gl_handle.h"
#include "app/render/render_target.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/scene/animation.h"

#include <GL/glu.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace texplorer::quads_test {
namespace {

using namespace test;

constexpr int extent = 200;

struct Camera {
    float azimuth;
    float elevation;
    float distance;
};
constexpr std::array cameras{Camera{0, 0, 5}, Camera{24, 18, 4}, Camera{-130, -35, 3.5F}, Camera{75, 80, 5},
                             Camera{200, -80, 4}};

struct Look {
    const char* name;
    bool lighting;
    ShadeModel shading;
    bool textured;
    bool seeThrough; ///< every triangle is seen, and their order
};

struct Solid {
    const char* name;
    ShapeOptions options;
};

/// A shape that GLU draws.
struct Quadric {
    Shape shape;
    void (*draw)(GLUquadric* quadric, const Model& model);
    bool upright;  ///< its z axis becomes our y axis
    float lowered; ///< along that axis
};
constexpr std::array quadrics{
    Quadric{
        Shape::Sphere,
        [](GLUquadric* quadric, const Model& model) { gluSphere(quadric, 1, model.slices, model.stacks); },
        true, 0},
    Quadric{Shape::Cylinder,
            [](GLUquadric* quadric, const Model& model) {
                gluCylinder(quadric, 1, double{model.topRadius}, 2, model.slices, model.stacks);
            },
            true, 1},
    Quadric{Shape::Disk,
            [](GLUquadric* quadric, const Model& model) {
                gluDisk(quadric, double{model.innerRadius}, 1, model.slices, model.stacks);
            },
            false, 0},
    Quadric{Shape::PartialDisk,
            [](GLUquadric* quadric, const Model& model) {
                gluPartialDisk(quadric, double{model.innerRadius}, 1, model.slices, model.stacks,
                               double{model.startAngle}, double{model.sweepAngle});
            },
            false, 0},
};

const Quadric* quadricOf(Shape shape) {
    const auto found = std::ranges::find(quadrics, shape, &Quadric::shape);
    return found == quadrics.end() ? nullptr : &*found;
}

/// An image without straight lines: every difference of interpolation is visible.
Image curvedImage() {
    Image made = Image::uninitialised(PixelFormat::Rgba8, 64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const std::array values{x * 4, y * 4, (x * x + y * y) / 32 % 256, 255};
            std::ranges::transform(values, made.at(x, y).begin(),
                                   [](int v) { return static_cast<std::byte>(v); });
        }
    return made;
}

/// The mesh's coordinates with one corner of each square moved: the two diagonals now give two pictures.
TexCoords pulledCoords(Shape shape) {
    TexCoords coords;
    for (const Vertex& vertex : makeMesh({shape}).vertices)
        coords.push_back(coords.size() % 4 == 2 ? vertex.texCoord * glm::vec4(1.5F, 2, 1, 1)
                                                : vertex.texCoord);
    return coords;
}

void drawQuads(const Mesh& mesh, const TexCoords& coords) {
    // In a list, where Mesa always divides in the same way: see core/mesh/mesh.h.
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glBegin(GL_QUADS);
    for (const Face& face : mesh.faces) {
        for (const std::uint32_t index : face.vertices) {
            const Vertex& vertex = mesh.vertices.at(index);
            glTexCoord4fv(glm::value_ptr(coords.at(index)));
            glNormal3fv(glm::value_ptr(vertex.normal));
            glVertex3fv(glm::value_ptr(vertex.position));
        }
    }
    glEnd();
    glEndList();
    glCallList(list);
    glDeleteLists(list, 1);
}

void drawQuadric(const Quadric& quadric, const Model& model) {
    constexpr std::array<float, 16> turn{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    if (quadric.upright)
        glMultMatrixf(turn.data());
    glTranslatef(0, 0, -quadric.lowered);
    const std::unique_ptr<GLUquadric, decltype(&gluDeleteQuadric)> state(gluNewQuadric(), gluDeleteQuadric);
    gluQuadricTexture(state.get(), GL_TRUE);
    quadric.draw(state.get(), model);
}

Model modelOf(const ShapeOptions& options) {
    return {.shape = options.shape,
            .slices = options.slices,
            .stacks = options.stacks,
            .topRadius = options.topRadius,
            .innerRadius = options.innerRadius,
            .startAngle = options.startAngle,
            .sweepAngle = options.sweepAngle};
}

class AsPrograms : public RenderTest, public testing::WithParamInterface<std::tuple<Solid, Look>> {
protected:
    static Scene sceneOf(const Solid& solid, const Look& look, const Camera& camera) {
        Scene scene = look.textured ? texturedScene() : flatScene();
        scene.view = {.azimuth = camera.azimuth, .elevation = camera.elevation, .distance = camera.distance};
        scene.models[0] = modelOf(solid.options);
        if (!quadricOf(solid.options.shape))
            scene.models[0].texCoords[0] = pulledCoords(solid.options.shape);
        scene.textures[0].magFilter = MagFilter::Linear;
        scene.textures[0].minFilter = MinFilter::Linear;
        scene.light.position = {1, 1.5F, -1.5F, 1}; // near: every vertex has a colour of its own
        scene.material = {.color = {0.9F, 0.7F, 0.5F, look.seeThrough ? 0.4F : 1},
                          .specular = {0.5F, 0.5F, 0.5F, 1},
                          .shininess = 16,
                          .shadeModel = look.shading};
        Pass& pass = scene.passes[0];
        pass.lighting = look.lighting;
        pass.units[0].envMode = EnvMode::Modulate;
        pass.depthTest = !look.seeThrough;
        pass.blend = look.seeThrough;
        pass.blendSrc = BlendFactor::SrcAlpha;
        pass.blendDst = BlendFactor::OneMinusSrcAlpha;
        return scene;
    }

    static void setState(const Scene& scene) {
        const View& view = scene.view;
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        const auto [near, far] = clipPlanes(view);
        const double top = near * std::tan(glm::radians(double{view.fieldOfView}) / 2);
        glFrustum(-top, top, -top, top, near, far);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(scene.light.position));
        glTranslatef(0, 0, -view.distance);
        glRotatef(view.elevation, 1, 0, 0);
        glRotatef(-view.azimuth, 0, 1, 0);
        glEnable(GL_LIGHT0);
        const Material& material = scene.material;
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, glm::value_ptr(material.specular));
        glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
        glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
        glEnable(GL_COLOR_MATERIAL);
        glEnable(GL_NORMALIZE);
        glColor4fv(glm::value_ptr(material.color));
        glShadeModel(static_cast<GLenum>(material.shadeModel));
        if (scene.passes[0].lighting)
            glEnable(GL_LIGHTING);
        if (scene.passes[0].depthTest)
            glEnable(GL_DEPTH_TEST);
        if (scene.passes[0].blend)
            glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }

    /// Drawn by a program that shares only numbers with Texplorer.
    static Image theirs(const Scene& scene) {
        render::RenderTarget target;
        EXPECT_TRUE(target.bind({extent, extent}));
        const render::TextureHandle texture = render::TextureHandle::create();
        const Image image = curvedImage();
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     image.pixels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        if (scene.passes[0].units[0].enabled)
            glEnable(GL_TEXTURE_2D);

        glViewport(0, 0, extent, extent);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        setState(scene);
        const Model& model = scene.models[0];
        if (const Quadric* quadric = quadricOf(model.shape))
            drawQuadric(*quadric, model);
        else
            drawQuads(makeMesh({model.shape}), model.texCoords[0]);
        Image found = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
        glReadPixels(0, 0, extent, extent, GL_RGBA, GL_UNSIGNED_BYTE, found.pixels.data());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return found;
    }
};

TEST_P(AsPrograms, DrawThem) {
    const auto& [solid, look] = GetParam();
    images.put("image", curvedImage());
    for (const Camera& camera : cameras) {
        SCOPED_TRACE(testing::Message()
                     << "azimuth " << camera.azimuth << ", elevation " << camera.elevation);
        const Scene scene = sceneOf(solid, look, camera);
        const Image ours = picture(scene, extent);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        const Image found = theirs(scene);
        glPopAttrib();
        ASSERT_EQ(found.pixels.size(), ours.pixels.size());
        int covered = 0;
        int others = 0;
        int worst = 0;
        for (std::size_t i = 0; i < found.pixels.size(); ++i) {
            const int difference =
                std::abs(std::to_integer<int>(found.pixels[i]) - std::to_integer<int>(ours.pixels[i]));
            covered += i % 4 == 3 && found.pixels[i] != std::byte{0} ? 1 : 0;
            others += difference > 0 ? 1 : 0;
            worst = std::max(worst, difference);
        }
        EXPECT_GT(covered, extent);
        // The shaders' matrices are not multiplied by OpenGL and differ in the last bits.
        EXPECT_LE(worst, testedRenderer() == RendererKind::Fixed ? 1 : 2) << others << " components differ";
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, AsPrograms,
    testing::Combine(
        testing::Values(
            Solid{"Cube", {Shape::Cube}}, Solid{"Quad", {Shape::Quad}}, Solid{"Floor", {Shape::Floor}},
            Solid{"Sphere32x16", {Shape::Sphere, 32, 16}}, Solid{"Sphere7x5", {Shape::Sphere, 7, 5}},
            Solid{"Sphere3x2", {Shape::Sphere, 3, 2}}, Solid{"Cylinder32x16", {Shape::Cylinder, 32, 16}},
            Solid{"Cone7x5", {.shape = Shape::Cylinder, .slices = 7, .stacks = 5, .topRadius = 0}},
            Solid{"Funnel5x3", {.shape = Shape::Cylinder, .slices = 5, .stacks = 3, .topRadius = 1.25F}},
            Solid{"Disk32x16", {Shape::Disk, 32, 16}}, Solid{"Disk5x3", {Shape::Disk, 5, 3}},
            Solid{"Ring7x5", {.shape = Shape::Disk, .slices = 7, .stacks = 5, .innerRadius = 0.25F}},
            Solid{"Sector9x4",
                  {.shape = Shape::PartialDisk,
                   .slices = 9,
                   .stacks = 4,
                   .innerRadius = 0.25F,
                   .startAngle = 30,
                   .sweepAngle = 270}},
            Solid{"Backwards8x2",
                  {.shape = Shape::PartialDisk,
                   .slices = 8,
                   .stacks = 2,
                   .startAngle = -40,
                   .sweepAngle = -300}}),
        testing::Values(Look{"Textured", false, ShadeModel::Smooth, true, false},
                        Look{"LitAndTextured", true, ShadeModel::Smooth, true, false},
                        Look{"Lit", true, ShadeModel::Smooth, false, false},
                        Look{"Flat", true, ShadeModel::Flat, false, false},
                        Look{"FlatAndTextured", true, ShadeModel::Flat, true, false},
                        Look{"SeeThrough", true, ShadeModel::Smooth, true, true})),
    [](const auto& test) {
        return std::string(std::get<0>(test.param).name) + std::get<1>(test.param).name;
    });

} // namespace
} // namespace texplorer::quads_test
