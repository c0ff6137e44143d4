#include "texplorer/scene/scene.h"

namespace texplorer {

Scene defaultScene() {
    Scene scene;
    scene.view.azimuth = 24;
    scene.view.elevation = 18;
    scene.view.distance = 7;
    scene.view.background = {0.11F, 0.13F, 0.16F, 1};

    scene.light.position = {0.4F, 0.7F, 1, 0};
    scene.material.specular = {0.5F, 0.5F, 0.5F, 1};
    scene.material.shininess = 32;

    Model cube;
    cube.shape = Shape::Cube;
    cube.position = {-1.45F, 0, 0};
    Model sphere;
    sphere.shape = Shape::Sphere;
    sphere.position = {1.45F, 0, 0};
    sphere.size = 1.25F;
    scene.models = {cube, sphere};

    Texture board;
    board.mipmaps = MipPolicy::Generated;
    board.minFilter = MinFilter::LinearMipmapLinear;
    scene.textures = {board};

    Pass& pass = scene.passes.front();
    pass.lighting = true;
    pass.depthTest = true;
    pass.units[0].enabled = true;
    return scene;
}

} // namespace texplorer
