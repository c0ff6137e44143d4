#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer::test {

/// A floor that runs to the horizon: every footprint from magnified to strongly minified.
[[nodiscard]] inline Scene floorScene() {
    Scene scene;
    scene.view.azimuth = 20;
    scene.view.elevation = 15;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Floor;
    scene.textures.resize(1);
    scene.textures[0].pattern = Pattern::Checker;
    scene.textures[0].mipmaps = MipPolicy::Generated;
    scene.passes[0].depthTest = true;
    scene.passes[0].units[0].enabled = true;
    return scene;
}

} // namespace texplorer::test
