#include "texplorer/conform/surfaces.h"

#include "texplorer/conform/feature.h"

namespace texplorer::conform {

namespace {

/// Where a coordinate is at the two ends of a quad: from the texel `first` on, an eighth of a texel to eight
/// texels a pixel. Pixel i is at first + 1/32 + (2 i + 1) step / 16 texels: an odd number of 32nds.
struct Run {
    float low;
    float high;
};

Run runOf(int texels, Dice& values) {
    constexpr std::array steps{1, 2, 3, 4, 5, 8, 11, 16, 24, 64};
    const auto step = static_cast<float>(values.of(steps)) / 8;
    const auto start = static_cast<float>(values.below(4 * texels) - 2 * texels) + 1.0F / 32;
    const auto size = static_cast<float>(texels);
    const Run run{start / size, (start + step * extent) / size};
    return values.chance(4) ? Run{run.high, run.low} : run;
}

/// Four squares in a row, folded between them, for Shape::Mesh.
MeshData foldedStrip() {
    MeshData mesh;
    mesh.primitive = Primitive::QuadStrip;
    for (int i = 0; i <= 4; ++i) {
        const auto fold = static_cast<float>(i);
        const float side = i % 2 == 0 ? -1.0F : 1.0F;
        for (const float y : {1.0F, -1.0F}) {
            mesh.positions.emplace_back(fold / 2 - 1, y, 0.3F * side);
            mesh.normals.emplace_back(0.5F * side, 0, 1);
            mesh.texCoords.emplace_back(fold / 4, (y + 1) / 2, 0, 1);
        }
    }
    return mesh;
}

} // namespace

Scene flatQuad(Dice& values) {
    Scene scene;
    scene.view.projection = Projection::Orthographic;
    scene.view.fieldOfView = 90; // at distance 1 that is a height of 2, from -1 to 1
    scene.view.distance = 1;
    scene.view.background = values.color();
    scene.material.color = values.color();
    Model quad;
    quad.shape = Shape::Quad;
    scene.models = {quad};
    return scene;
}

void setSource(Texture& texture, const Source& source) {
    texture.pattern = source.pattern;
    texture.baseLevel = source.level;
    texture.mipmaps = source.level > 0 ? MipPolicy::Generated : MipPolicy::None;
    texture.minFilter = MinFilter::Nearest;
    texture.magFilter = MagFilter::Nearest;
}

void placeTexels(Model& quad, std::size_t unit, const Source& source, Dice& values) {
    const Run s = runOf(source.width, values);
    const Run t = runOf(source.height, values);
    // The middle of a slice, for volumes: they have as many of them as texels across.
    const float r = (static_cast<float>(values.below(2 * source.width)) -
                     0.5F * static_cast<float>(source.width) + 0.5F) /
                    static_cast<float>(source.width);
    quad.texCoords[unit].clear();
    for (const Vertex& vertex : makeMesh({Shape::Quad}).vertices)
        quad.texCoords[unit].emplace_back(vertex.position.x > 0 ? s.high : s.low,
                                          vertex.position.y > 0 ? t.high : t.low, r, 1);
}

Scene texturedQuad(const Source& source, Dice& values) {
    Scene scene = flatQuad(values);
    scene.textures.resize(1);
    setSource(scene.textures[0], source);
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    placeTexels(scene.models[0], 0, source, values);
    return scene;
}

Scene surface(Shape shape, Dice& values) {
    constexpr std::array patterns{Pattern::Checker, Pattern::Brick, Pattern::Tree, Pattern::CheckerRed};
    Scene scene;
    scene.view.background = values.color();
    scene.view.azimuth = values.number(-40, 40);
    scene.view.elevation = values.number(8, 40);
    scene.view.distance = shape == Shape::Floor ? 6 : values.number(2.6F, 5);
    scene.material.color = values.color();
    Model model;
    model.shape = shape;
    if (shape == Shape::Mesh)
        model.mesh = foldedStrip();
    if (shape == Shape::Quad || shape == Shape::Disk || shape == Shape::PartialDisk || shape == Shape::Mesh)
        model.rotation = {values.number(-70, 30), values.number(-60, 60), values.number(0, 360)};
    else if (shape != Shape::Floor)
        model.rotation = {values.number(0, 360), values.number(0, 360), values.number(0, 360)};
    scene.models = {model};
    scene.textures.resize(1);
    scene.textures[0].pattern = values.of(patterns);
    scene.textures[0].mipmaps = MipPolicy::Generated;
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    scene.passes[0].depthTest = true;
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    return scene;
}

glm::mat4 planeMatrix(Dice& values) {
    glm::mat4 matrix(1);
    matrix[0] = {values.number(0.5F, 2), values.number(-1, 1), 0, 0};
    matrix[1] = {values.number(-1, 1), values.number(0.5F, 2), 0, 0};
    matrix[3] = {values.number(-1, 1), values.number(-1, 1), 0, 1};
    return matrix;
}

void setLight(Scene& scene, Dice& values) {
    scene.passes[0].lighting = true;
    Light& light = scene.light;
    light.position = {values.number(-2, 2), values.number(-2, 2), values.number(0.5F, 3), light.position.w};
    light.ambient = values.color();
    light.diffuse = values.color();
    light.specular = values.color();
    light.modelAmbient = values.color();
    scene.material.specular = values.color();
    scene.material.shininess = values.number(0, 40);
}

} // namespace texplorer::conform
