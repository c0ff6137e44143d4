#include "texplorer/scene/drawn_models.h"

#include <algorithm>

namespace texplorer {

std::vector<std::size_t> drawnModels(const Scene& scene, const Pass& pass) {
    std::vector<std::size_t> drawn;
    if (!pass.enabled)
        return drawn;
    const auto add = [&](std::size_t index) {
        if (index < scene.models.size() && scene.models[index].visible)
            drawn.push_back(index);
    };
    if (pass.models.empty()) {
        for (std::size_t i = 0; i < scene.models.size(); ++i)
            add(i);
    } else {
        for (const int index : pass.models)
            add(static_cast<std::size_t>(index));
    }
    return drawn;
}

std::string nameOf(const Model& model) {
    return model.name.empty() ? std::string(rowOf(model.shape).label) : model.name;
}

namespace {

bool draws(const Scene& scene, const Pass& pass, std::size_t model) {
    const std::vector<std::size_t> drawn = drawnModels(scene, pass);
    return std::ranges::find(drawn, model) != drawn.end();
}

} // namespace

bool isDrawn(const Scene& scene, std::size_t model) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) { return draws(scene, pass, model); });
}

bool isInWindow(const Scene& scene, std::size_t model) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return pass.picture == 0 && draws(scene, pass, model);
    });
}

bool drawsAnything(const Scene& scene, const Pass& pass) {
    return !drawnModels(scene, pass).empty();
}

void drawEverywhere(Scene& scene, std::size_t model) {
    const int index = static_cast<int>(model);
    for (Pass& pass : scene.passes) {
        if (!pass.models.empty() && std::ranges::find(pass.models, index) == pass.models.end())
            pass.models.push_back(index);
    }
}

} // namespace texplorer
