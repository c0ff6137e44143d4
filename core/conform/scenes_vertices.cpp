// Models: vertices of their own, quadrics, materials, and where models are.

#include "texplorer/conform/scenes.h"
#include "texplorer/conform/surfaces.h"

#include <algorithm>

namespace texplorer::conform::scenes {

namespace {

constexpr std::array thinPrimitives{Primitive::Points, Primitive::Lines, Primitive::LineStrip,
                                    Primitive::LineLoop};
constexpr std::array polygonPrimitives{Primitive::Triangles, Primitive::TriangleStrip, Primitive::TriangleFan,
                                       Primitive::Quads,     Primitive::QuadStrip,     Primitive::Polygon};

/// Twelve places around a circle that every machine computes alike.
constexpr std::array rim{glm::vec2(1, 0),  glm::vec2(0.8F, 0.6F),   glm::vec2(0.6F, 0.8F),
                         glm::vec2(0, 1),  glm::vec2(-0.6F, 0.8F),  glm::vec2(-0.8F, 0.6F),
                         glm::vec2(-1, 0), glm::vec2(-0.8F, -0.6F), glm::vec2(-0.6F, -0.8F),
                         glm::vec2(0, -1), glm::vec2(0.6F, -0.8F),  glm::vec2(0.8F, -0.6F)};

/// How far from the middle a vertex lies, so that the parts of a primitive are polygons that OpenGL defines:
/// strips are rings, quadrilaterals go around, the others are as the rim is.
float radiusOf(Primitive primitive, std::size_t vertex) {
    constexpr float inner = 0.4F;
    switch (primitive) {
    case Primitive::Triangles:
    case Primitive::TriangleStrip:
    case Primitive::QuadStrip:
        return vertex % 2 == 1 ? inner : 1;
    case Primitive::Quads:
        return vertex % 4 == 1 || vertex % 4 == 2 ? inner : 1;
    case Primitive::TriangleFan:
        return vertex == 0 ? 0 : 1;
    default:
        return 1;
    }
}

/// Such vertices, moved somewhat out of their plane unless they are one polygon's, with normals anywhere.
MeshData polygons(Primitive primitive, Dice& values) {
    MeshData mesh;
    mesh.primitive = primitive;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const glm::vec2 place = rim.at(i) * radiusOf(primitive, i);
        const float z = primitive == Primitive::Polygon ? 0 : values.number(-0.4F, 0.4F);
        mesh.positions.emplace_back(place, z);
        mesh.normals.emplace_back(values.number(-1, 1), values.number(-1, 1), values.number(0.2F, 2));
    }
    return mesh;
}

void setColors(MeshData& mesh, Dice& values) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.colors.push_back(values.color());
}

/// A lit surface without a texture.
Scene litSurface(Shape shape, Dice& state, Dice& values) {
    Scene scene = surface(shape, values);
    scene.passes[0].units[0].enabled = false;
    scene.material.shadeModel = state.any<ShadeModel>();
    setLight(scene, values);
    return scene;
}

/// What is reflected without GL_COLOR_MATERIAL, and what shines by itself: little, so that no sum reaches 1.
void setReflectances(Material& material, Dice& values) {
    material.color = values.color();
    material.ambient = values.color();
    material.diffuse = values.color();
    material.emission = values.color() * 0.3F;
}

} // namespace

Scene lines(int number, Dice& state, Dice& values) {
    constexpr std::array widths{1, 3, 5, 7};
    const Primitive primitive = thinPrimitives[static_cast<std::size_t>(number) % thinPrimitives.size()];
    const bool textured = number / static_cast<int>(thinPrimitives.size()) % 2 == 1;
    Scene scene = surface(Shape::Mesh, values);
    scene.view.distance = values.number(4, 5); // all of it is in view
    scene.material.shadeModel = state.any<ShadeModel>();
    Model& model = scene.models[0];
    model.lineWidth = static_cast<float>(values.of(widths));
    if (textured) // a quarter of a pixel is a texel there: see rules::lines
        model.lineWidth = std::max(model.lineWidth, 3.0F);
    model.pointSize = static_cast<float>(1 + values.below(7));
    model.mesh = {.primitive = primitive};
    for (int i = 0; i < 12; ++i) {
        model.mesh.positions.emplace_back(values.number(-0.57F, 0.57F), values.number(-0.57F, 0.57F),
                                          values.number(-0.57F, 0.57F));
        model.mesh.texCoords.emplace_back(values.number(-1, 2), values.number(-1, 2), 0, 1);
    }
    if (!state.chance(3))
        setColors(model.mesh, values);
    setSource(scene.textures[0], state.of(coloredSources));
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    Pass& pass = scene.passes[0];
    pass.depthTest = state.chance(2);
    pass.units[0].enabled = textured;
    pass.units[0].envMode = EnvMode::Modulate;
    if (textured && state.chance(3)) { // points of one colour, and lines
        for (int vertex = values.below(3); vertex < 12; vertex += 1 + values.below(4))
            model.noTexCoord[0].push_back(vertex);
    }
    return scene;
}

Scene meshes(int number, Dice& state, Dice& values) {
    const Primitive primitive =
        polygonPrimitives[static_cast<std::size_t>(number) % polygonPrimitives.size()];
    Scene scene = litSurface(Shape::Mesh, state, values);
    scene.passes[0].lighting = state.chance(2);
    MeshData& mesh = scene.models[0].mesh;
    mesh = polygons(primitive, values);
    // Without light a mesh of one colour shows no more than its outline.
    if (!scene.passes[0].lighting || state.chance(2))
        setColors(mesh, values);
    if (state.chance(2)) { // a fan around the other way, everything else from another vertex on
        const bool fan = primitive == Primitive::TriangleFan;
        const int first = fan ? 0 : primitive == Primitive::Triangles ? 3 : 4;
        for (int i = 0; i < 12; ++i)
            mesh.indices.push_back((first + i) % 12);
        if (fan)
            std::reverse(mesh.indices.edit().begin() + 1, mesh.indices.edit().end());
    }
    return scene;
}

Scene quadrics(int number, Dice& state, Dice& values) {
    constexpr std::array shapes{Shape::Cylinder, Shape::Disk, Shape::PartialDisk, Shape::Torus,
                                Shape::Teapot};
    const Shape shape = shapes[static_cast<std::size_t>(number) % shapes.size()];
    const bool extreme = number / static_cast<int>(shapes.size()) % 3 == 2; // a cone, no hole, a thin ring
    Scene scene = litSurface(shape, state, values);
    Model& model = scene.models[0];
    model.slices = 3 + values.below(30);
    model.stacks = 3 + values.below(14); // a torus of two is flat, and lies on itself
    model.topRadius = extreme ? 0 : values.number(0.2F, 1.2F);
    model.innerRadius = extreme ? 0 : values.number(0.1F, 0.8F);
    model.tubeRadius = extreme ? 0.05F : values.number(0.1F, 0.6F);
    model.startAngle = values.number(-360, 360);
    model.sweepAngle = values.number(-360, 360);
    return scene;
}

Scene materials(int number, Dice& state, Dice& values) {
    Scene scene = litSurface(Shape::Sphere, state, values);
    setReflectances(scene.material, values);
    scene.material.colorMaterial = number % 2 == 0;
    scene.view.distance = 5;
    Model& left = scene.models[0];
    left.position.x = -0.8F;
    left.size = 0.7F;
    Model right = left;
    right.shape = Shape::Cube;
    right.position.x = 0.8F;
    right.ownMaterial = number / 2 % 2 == 0;
    setReflectances(right.material, values);
    right.material.colorMaterial = number / 4 % 2 == 0;
    right.material.specular = values.color();
    right.material.shininess = values.number(0, 40);
    scene.models.push_back(right);
    return scene;
}

Scene placement(int number, Dice& state, Dice& values) {
    const RotationOrder order = pick<RotationOrder>(number);
    const bool beforeTheEye = number % 2 == 1;
    Scene scene = litSurface(Shape::Cube, state, values);
    scene.view.roll = values.number(-180, 180);
    scene.view.distance = values.number(4.5F, 7);
    Model& model = scene.models[0];
    model.rotationOrder = order;
    model.scale = {values.number(0.4F, 1.3F), values.number(0.4F, 1.3F), values.number(0.4F, 1.3F)};
    model.position = {values.number(-0.4F, 0.4F), values.number(-0.4F, 0.4F), 0};
    if (beforeTheEye) {
        model.attachment = Attachment::Eye;
        model.position.z = -values.number(4.5F, 7);
    }
    return scene;
}

Scene emboss(int number, Dice& state, Dice& values) {
    constexpr std::array shapes{Shape::Cube, Shape::Sphere, Shape::Quad, Shape::Torus};
    const LightCarrier carrier = pick<LightCarrier>(number);
    const bool placed = number % 2 == 1;
    Scene scene = surface(shapes[static_cast<std::size_t>(number / 2) % shapes.size()], values);
    setSource(scene.textures[0], state.of(coloredSources));
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    scene.light.position = {values.number(-2, 2), values.number(-2, 2), values.number(0.5F, 3),
                            placed ? 1.0F : 0.0F};
    scene.passes[0].units[0].emboss = {true, values.number(0.02F, 0.2F), carrier};
    return scene;
}

} // namespace texplorer::conform::scenes
