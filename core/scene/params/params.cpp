#include "core/scene/params/params.h"

#include "core/scene/params/param_builder.h"

namespace texplorer {

const StructTable& sceneTable() {
    static const std::array children{
        build::single<&Scene::view>("view", "View", viewTable()),
        build::single<&Scene::light>("light", "Light", lightTable()),
        build::single<&Scene::material>("material", "Material", materialTable()),
        build::many<&Scene::models>("models", "Model", modelTable(), 0, maxModels),
        build::many<&Scene::textures>("textures", "Texture", textureTable(), 0, maxTextures),
        build::many<&Scene::passes>("passes", "Pass", passTable(), 1, maxPasses),
    };
    static_assert(children.size() == 6 && children.size() == build::memberCount<Scene>());
    static const StructTable table{"Scene", {}, children};
    return table;
}

const ParamRow* findParam(const StructTable& table, std::string_view key) {
    const auto found = std::ranges::find(table.params, key, &ParamRow::key);
    return found == table.params.end() ? nullptr : &*found;
}

const ChildRow* findChild(const StructTable& table, std::string_view key) {
    const auto found = std::ranges::find(table.children, key, &ChildRow::key);
    return found == table.children.end() ? nullptr : &*found;
}

std::vector<std::string_view> tableKeys(const StructTable& table) {
    std::vector<std::string_view> keys;
    for (const ParamRow& row : table.params)
        keys.push_back(row.key);
    for (const ChildRow& child : table.children)
        keys.push_back(child.key);
    return keys;
}

} // namespace texplorer
