#include "texplorer/emit/emission.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

namespace texplorer::emit {
namespace {

/// As OpenGL begins: the scene's begins with what most programs switch on.
const Material& initialMaterial() {
    static const Material initial{.colorMaterial = false};
    return initial;
}

/// What glColor sets as well, where GL_COLOR_MATERIAL is on.
bool followsColor(const ParamRow& row) {
    return row.member == memberId<&Material::ambient> || row.member == memberId<&Material::diffuse>;
}

/// Without light the colour is all that is looked at, and how it is interpolated.
bool looksAt(const Emission& emission, const ParamRow& row) {
    return emission.isLit || row.member == memberId<&Material::color> ||
           row.member == memberId<&Material::shadeModel>;
}

void writeRows(Emission& emission, const Holder& holder, bool all) {
    CodeWriter& writer = emission.writer;
    const bool isFollowing = static_cast<const Material*>(holder.values)->colorMaterial;
    const ParamRow& follows = *findParam(holder.table, keyOf<&Material::colorMaterial>());
    const bool beginsToFollow = isFollowing && writer.differs(holder, follows);
    if (beginsToFollow) {
        // glColor comes after it: the colour that there is Mesa 22.3 copies where glMaterial hasn't set
        // another.
        writer.row(holder, follows, emission.isLit);
        writer.forget(fmt::format("{}.{}", holder.state, keyOf<&Material::color>()));
    }
    for (const ParamRow& row : holder.table.params) {
        if (isFollowing && followsColor(row))
            writer.forget(fmt::format("{}.{}", holder.state, row.key));
        else if (beginsToFollow && row.member == follows.member)
            continue;
        else if (all || writer.differs(holder, row))
            writer.row(holder, row, looksAt(emission, row));
    }
}

Holder holderOf(const Scene& scene) {
    const std::string& key = keyOf<&Scene::material>();
    return {materialTable(), &scene.material, &initialMaterial(), key, key, key};
}

/// That of a model: the scene's, or its own.
Holder holderOf(const Scene& scene, std::size_t index) {
    const Model& model = scene.models[index];
    const std::string& key = keyOf<&Scene::material>();
    Holder holder{modelMaterialTable(), &materialOf(scene, model), &initialMaterial(), key, key, key};
    if (model.ownMaterial) {
        holder.path = fmt::format("{}.{}", elementOf<&Scene::models>(index), keyOf<&Model::material>());
        holder.variable = joined(fmt::format("model{}", index), key);
    }
    return holder;
}

/// The model that a frame begins with.
std::optional<std::size_t> firstModel(const Scene& scene) {
    for (const Pass& pass : scene.passes) {
        if (const std::vector<std::size_t> models = drawnModels(scene, pass);
            drawsAnything(scene, pass) && !models.empty())
            return models.front();
    }
    return std::nullopt;
}

} // namespace

void writeMaterial(Emission& emission) {
    const Scene& scene = emission.scene;
    const Holder ofTheScene = holderOf(scene);
    emission.writer.heading(ofTheScene.path);
    // That of the first model at once: if the first frame begins with another than it goes on with, Mesa 22.3
    // mixes both up.
    const std::optional<std::size_t> first = firstModel(scene);
    if (!first || !scene.models[*first].ownMaterial)
        return writeRows(emission, ofTheScene, true);
    writeRows(emission, holderOf(scene, *first), true);
    emission.writer.row(ofTheScene, memberId<&Material::shadeModel>);
}

void writeMovingShadeModel(Emission& emission) {
    emission.writer.take(Taking::Moving);
    emission.writer.row(holderOf(emission.scene), memberId<&Material::shadeModel>);
    emission.writer.take(Taking::All);
}

void writeMaterial(Emission& emission, std::size_t index) {
    writeRows(emission, holderOf(emission.scene, index), false);
}

} // namespace texplorer::emit
