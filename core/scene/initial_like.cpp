#include "texplorer/scene/initial_like.h"

namespace texplorer {

Scene initialLike(const Scene& scene) {
    Scene initial;
    initial.models.resize(scene.models.size());
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        for (std::size_t u = 0; u < maxUnits; ++u)
            initial.models[m].units[u].matrix.resize(scene.models[m].units[u].matrix.size());
    }
    initial.textures.resize(scene.textures.size());
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        initial.textures[i].levels.resize(scene.textures[i].levels.size());
        initial.textures[i].preparation.resize(scene.textures[i].preparation.size());
    }
    initial.passes.resize(scene.passes.size());
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u)
            initial.passes[p].units[u].matrix.resize(scene.passes[p].units[u].matrix.size());
    }
    return initial;
}

} // namespace texplorer
