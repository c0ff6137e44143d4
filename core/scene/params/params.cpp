#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_builder.h"

#include <cassert>

namespace texplorer {

/// In params_timeline.cpp: a list whose elements lie one struct deeper.
ChildRow timelineRow();

const StructTable& sceneTable() {
    static const std::array children{
        build::single<&Scene::view>("view", N_("View"), viewTable()),
        build::single<&Scene::light>("light", N_("Light"), lightTable()),
        build::single<&Scene::material>("material", N_("Material"), materialTable()),
        build::many<&Scene::models>("models", N_("Model"), modelTable(), 0, maxModels),
        build::many<&Scene::textures>("textures", N_("Texture"), textureTable(), 0, maxTextures),
        build::many<&Scene::passes>("passes", N_("Pass"), passTable(), 1, maxPasses),
        timelineRow(),
    };
    static_assert(children.size() == 7 && children.size() == build::memberCount<Scene>());
    static const StructTable table{N_("Scene"), {}, children};
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

namespace {

/// Where a member has a row: in this table or below it; empty: nowhere.
std::string_view findKeyIn(const StructTable& table, MemberId member, std::size_t element) {
    for (const ParamRow& row : table.params) {
        if (row.member == member && element-- == 0)
            return row.key;
    }
    for (const ChildRow& child : table.children) {
        if (child.member == member)
            return child.key;
        if (const std::string_view below = findKeyIn(*child.table, member, element); !below.empty())
            return below;
    }
    return {};
}

} // namespace

std::string_view findKey(MemberId member, std::size_t element) {
    const std::string_view key = findKeyIn(sceneTable(), member, element);
    assert(!key.empty()); // every member has a row, see build::memberCount
    return key;
}

} // namespace texplorer
