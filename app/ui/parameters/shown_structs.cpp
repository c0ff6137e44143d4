#include "app/ui/parameters/shown_structs.h"

#include "app/ui/parameters/texture_lists.h"
#include "app/ui/parameters/unit_bar.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <utility>

namespace texplorer::ui {
namespace {

class Places {
public:
    /// `initial` must outlive the result.
    template<class Struct>
    void add(Section section, std::string title, const Struct& values, const Struct& initial,
             std::string path, const StructTable& table) {
        add(section, std::move(title), Owner{&values, &initial, std::move(path)}, table);
    }
    void add(Section section, std::string title, Owner owner, const StructTable& table) {
        places_.push_back({section, std::move(title), std::move(owner), &table});
    }
    [[nodiscard]] std::vector<ShownStruct> take() { return std::move(places_); }

private:
    std::vector<ShownStruct> places_;
};

void addUnitPlaces(Places& places, const Session& session) {
    static const Unit initial;
    static const MatrixStep initialStep;
    const Unit& unit = selectedUnit(session);
    const std::string path = selectedUnitPath(session) + ".";
    places.add(Section::Unit, "", unitOwner(session), unitTable());
    places.add(Section::Combine, "Combine", unit.combine, initial.combine, path + keyOf<&Unit::combine>(),
               combineTable());
    places.add(Section::Coordinates, "Generated s", unit.texGenS, initial.texGenS,
               path + keyOf<&Unit::texGenS>(), texGenTable(0));
    places.add(Section::Coordinates, "Generated t", unit.texGenT, initial.texGenT,
               path + keyOf<&Unit::texGenT>(), texGenTable(1));
    places.add(Section::Coordinates, "Generated r", unit.texGenR, initial.texGenR,
               path + keyOf<&Unit::texGenR>(), texGenTable(2));
    places.add(Section::Coordinates, "Generated q", unit.texGenQ, initial.texGenQ,
               path + keyOf<&Unit::texGenQ>(), texGenTable(3));
    places.add(Section::Coordinates, "Emboss", unit.emboss, initial.emboss, path + keyOf<&Unit::emboss>(),
               embossTable());
    for (std::size_t i = 0; i < unit.matrix.size(); ++i)
        places.add(Section::Matrix, fmt::format("Matrix step {}", i + 1), unit.matrix[i], initialStep,
                   path + elementOf<&Unit::matrix>(i), matrixStepTable());
}

void addModelPlaces(Places& places, const Session& session) {
    static const Model initial;
    const Model* model = selectedModel(session);
    if (!model)
        return;
    const std::string path =
        elementOf<&Scene::models>(static_cast<std::size_t>(session.window.selection.model));
    places.add(Section::Model, "Model", *model, initial, path, modelTable());
    if (model->ownMaterial)
        places.add(Section::Model, "Material of the model", model->material, initial.material,
                   fmt::format("{}.{}", path, keyOf<&Model::material>()), modelMaterialTable());
}

} // namespace

Owner textureOwner(const Session& session) {
    static const Texture initial;
    const Texture* texture = boundTexture(session);
    const std::string path =
        elementOf<&Scene::textures>(static_cast<std::size_t>(selectedUnit(session).texture));
    return {texture, &initial, path, [&session, path, texture](const ParamRow& row, const Value& value) {
                return acceptsFile(session, path, texture->file, row, value);
            }};
}

Owner unitOwner(const Session& session) {
    static const Unit initial;
    const auto accepts = [&session](const ParamRow& row, const Value& value) {
        if (row.member != memberId<&Unit::enabled>)
            return true;
        switchUnit(session, session.window.selection.unit, std::get<bool>(value)); // with a texture
        return false;
    };
    return {&selectedUnit(session), &initial, selectedUnitPath(session), accepts};
}

Owner materialOwner(const Session& session) {
    static const Material initial;
    return {&presentScene(session).material, &initial, keyOf<&Scene::material>()};
}

std::vector<ShownStruct> shownStructs(const Session& session) {
    static const Scene initial;
    static const Pass initialPass;
    static const View start = defaultScene().view;
    const Scene& scene = presentScene(session);
    Places places;
    if (boundTexture(session))
        places.add(Section::Texture, "", textureOwner(session), textureTable());
    addUnitPlaces(places, session);
    const std::string pass =
        elementOf<&Scene::passes>(static_cast<std::size_t>(session.window.selection.pass));
    places.add(Section::Pass, "", selectedPass(session), initialPass, pass, passTable());
    places.add(Section::Pass, "Fog", selectedPass(session).fog, initialPass.fog,
               fmt::format("{}.{}", pass, keyOf<&Pass::fog>()), fogTable());
    places.add(Section::Light, "", scene.light, initial.light, keyOf<&Scene::light>(), lightTable());
    places.add(Section::Light, "Projector", scene.light.projector, initial.light.projector,
               pathOf<&Scene::light, &Light::projector>(), projectorTable());
    places.add(Section::Material, "Material", materialOwner(session), materialTable());
    addModelPlaces(places, session);
    places.add(Section::View, "Camera", scene.view, start, keyOf<&Scene::view>(), viewTable());
    return places.take();
}

} // namespace texplorer::ui
