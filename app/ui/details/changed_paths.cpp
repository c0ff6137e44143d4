#include "app/ui/details/changed_paths.h"

#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace texplorer::ui {
namespace {

/// A model's coordinates for a unit.
struct CoordList {
    std::size_t model;
    std::size_t unit;
};

std::string pathOf(const CoordList& list) {
    return fmt::format("{}.{}", elementOf<&Scene::models>(list.model),
                       findKey(memberId<&Model::texCoords>, list.unit));
}

std::optional<CoordList> coordListAt(const Scene& scene, const std::string& path) {
    for (std::size_t model = 0; model < scene.models.size(); ++model) {
        if (!path.starts_with(elementOf<&Scene::models>(model) + "."))
            continue;
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            if (const CoordList list{model, unit}; pathOf(list) == path)
                return list;
        }
    }
    return std::nullopt;
}

TexCoords coordsOf(const Scene& scene, const CoordList& list) {
    const Model& model = scene.models[list.model];
    return effectiveTexCoords(model, meshOf(model), static_cast<int>(list.unit));
}

} // namespace

ChangedPaths changedPaths(const Document& document) {
    const std::string& path = document.lastChanged;
    if (path.empty())
        return {};
    const History& history = document.history;
    const std::optional<CoordList> list = coordListAt(document.scene, path);
    if (!list || !history.canUndo())
        return {path};
    const Scene& before = history.sceneOf(history.position() - 1);
    if (list->model >= before.models.size())
        return {path};
    const TexCoords was = coordsOf(before, *list);
    const TexCoords is = coordsOf(document.scene, *list);
    ChangedPaths changed;
    for (std::size_t vertex = 0; vertex < is.size(); ++vertex) {
        if (vertex >= was.size() || was[vertex] != is[vertex])
            changed.insert(fmt::format("{}[{}]", path, vertex));
    }
    return changed;
}

bool mentionsAny(const emit::Line& line, const ChangedPaths& paths) {
    return std::ranges::any_of(line.parts, [&](const emit::Part& part) { return paths.contains(part.path); });
}

} // namespace texplorer::ui
