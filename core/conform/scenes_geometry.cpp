#include "texplorer/conform/scenes.h"
#include "texplorer/conform/surfaces.h"

#include <utility>

namespace texplorer::conform::scenes {

Scene coverage(int number, Dice& /*state*/, Dice& values) {
    const Projection projection = pick<Projection>(number);
    Scene scene = surface(pick<Shape>(number), values);
    scene.view.projection = projection;
    scene.view.distance += values.number(0, 3);
    scene.models[0].rotation = {values.number(-60, 60), values.number(-60, 60), values.number(0, 360)};
    scene.passes[0].units[0].enabled = false;
    return scene;
}

Scene depth(int number, Dice& /*state*/, Dice& values) {
    Scene scene = surface(Shape::Cube, values);
    setLight(scene, values);
    scene.passes[0].units[0].enabled = false;
    scene.passes[0].depthFunc = pick<CompareFunc>(number);
    scene.models.resize(3, scene.models[0]);
    scene.models[1].shape = Shape::Sphere;
    scene.models[2].shape = Shape::Quad;
    for (Model& model : scene.models) {
        model.position = {values.number(-0.7F, 0.7F), values.number(-0.7F, 0.7F), values.number(-0.7F, 0.7F)};
        model.rotation = {values.number(0, 360), values.number(0, 360), 0};
        model.size = values.number(0.5F, 1);
    }
    scene.view.distance = 5;
    return scene;
}

Scene lighting(int number, Dice& /*state*/, Dice& values) {
    const bool round = number % 2 == 0;
    number /= 2;
    Scene scene = surface(round ? Shape::Sphere : Shape::Cube, values);
    scene.passes[0].units[0].enabled = false;
    scene.material.shadeModel = pick<ShadeModel>(number);
    scene.light.colorControl = pick<ColorControl>(number);
    scene.light.localViewer = number % 2 == 1;
    scene.light.position.w = number / 2 % 2 == 1 ? 1.0F : 0.0F;
    setLight(scene, values);
    return scene;
}

Scene separateSpecular(int number, Dice& state, Dice& values) {
    Scene scene = surface(number % 2 == 0 ? Shape::Sphere : Shape::Cube, values);
    number /= 2;
    setSource(scene.textures[0], state.of(coloredSources));
    scene.passes[0].units[0].envMode = pick<EnvMode>(number);
    scene.light.colorControl = ColorControl::SeparateSpecular;
    setLight(scene, values);
    return scene;
}

Scene twoSided(int number, Dice& state, Dice& values) {
    constexpr std::array shapes{Shape::Quad, Shape::Cylinder, Shape::Mesh, Shape::PartialDisk, Shape::Torus};
    const ColorControl control = pick<ColorControl>(number);
    const ShadeModel shading = pick<ShadeModel>(number);
    Scene scene = surface(shapes[static_cast<std::size_t>(number) % shapes.size()], values);
    scene.passes[0].units[0].enabled = false;
    scene.material.shadeModel = shading;
    scene.light.colorControl = control;
    scene.light.twoSide = true;
    scene.light.localViewer = state.chance(2);
    scene.light.position.w = state.chance(2) ? 1.0F : 0.0F;
    setLight(scene, values);
    Model& model = scene.models[0];
    model.rotation = {values.number(0, 360), values.number(0, 360), values.number(0, 360)};
    if (values.chance(2)) { // mirrored: what was its front is seen from behind
        for (glm::vec3& position : model.mesh.positions.edit())
            position.x = -position.x;
    }
    return scene;
}

Scene fog(int number, Dice& state, Dice& values) {
    constexpr std::array shapes{Shape::Cube, Shape::Floor, Shape::Sphere, Shape::Mesh, Shape::Torus};
    const FogMode mode = pick<FogMode>(number);
    const Projection projection = pick<Projection>(number);
    Scene scene = surface(shapes[static_cast<std::size_t>(number) % shapes.size()], values);
    scene.view.projection = projection;
    Pass& pass = scene.passes[0];
    pass.units[0].enabled = false;
    if (state.chance(2)) {
        scene.light.colorControl = state.any<ColorControl>();
        setLight(scene, values);
    }
    pass.fog = {true,          mode, values.number(0, 0.5F), values.number(0, 4), values.number(4.5F, 12),
                values.color()};
    if (values.chance(6)) // clear where it is far
        std::swap(pass.fog.start, pass.fog.end);
    return scene;
}

} // namespace texplorer::conform::scenes
