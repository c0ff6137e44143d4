#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/upload_edits.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::ui {
namespace {

using Places = std::vector<ShownStruct>;

/// `initial` must outlive the result.
template<class Struct>
void add(Places& places, Section section, const char* title, const Struct& values, const Struct& initial,
         std::string path, const StructTable& table) {
    places.push_back({section, title, {&values, &initial, std::move(path)}, &table});
}

struct TexGenPlace {
    const char* title;
    TexGen Unit::*state;
    Key key; ///< of the unit
};
constexpr std::array texGenPlaces{TexGenPlace{N_("Generated s"), &Unit::texGenS, keyOf<&Unit::texGenS>},
                                  TexGenPlace{N_("Generated t"), &Unit::texGenT, keyOf<&Unit::texGenT>},
                                  TexGenPlace{N_("Generated r"), &Unit::texGenR, keyOf<&Unit::texGenR>},
                                  TexGenPlace{N_("Generated q"), &Unit::texGenQ, keyOf<&Unit::texGenQ>}};

/// The rows of a matrix step. Its amount has the name of what it is.
const StructTable& stepTable(MatrixOp op) {
    const auto withAmount = [](const char* name) {
        const StructTable& table = matrixStepTable();
        std::vector<ParamRow> rows(table.params.begin(), table.params.end());
        std::ranges::find(rows, memberId<&MatrixStep::amount>, &ParamRow::member)->label = name;
        return rows;
    };
    static const std::array rows{withAmount(N_("Offset")), withAmount(N_("Axis")), withAmount(N_("Factors"))};
    static const std::array tables{StructTable{matrixStepTable().name, rows[0], {}},
                                   StructTable{matrixStepTable().name, rows[1], {}},
                                   StructTable{matrixStepTable().name, rows[2], {}}};
    const auto kind = static_cast<std::size_t>(op); // Translate, Rotate, Scale
    return kind < tables.size() ? tables.at(kind) : matrixStepTable();
}

void addUnitPlaces(Places& places, const Session& session) {
    static const Unit initial;
    static const MatrixStep initialStep;
    const Unit& unit = selectedUnit(session);
    const std::string path = selectedUnitPath(session) + ".";
    places.push_back({Section::Unit, "", unitOwner(session), &unitTable()});
    add(places, Section::Combine, N_("Combine"), unit.combine, initial.combine,
        path + keyOf<&Unit::combine>(), combineTable());
    for (std::size_t i = 0; i < texGenPlaces.size(); ++i) {
        const auto& [title, state, key] = texGenPlaces.at(i);
        add(places, Section::Coordinates, title, unit.*state, initial.*state, path + key(), texGenTable(i));
    }
    add(places, Section::Coordinates, N_("Emboss"), unit.emboss, initial.emboss,
        path + keyOf<&Unit::emboss>(), embossTable());
    for (std::size_t i = 0; i < unit.matrix.size(); ++i)
        places.push_back({Section::Matrix,
                          Sentence("Matrix step {0}", i + 1),
                          {&unit.matrix[i], &initialStep, path + elementOf<&Unit::matrix>(i)},
                          &stepTable(unit.matrix[i].op)});
    const Model* model = selectedModel(session);
    const auto number = static_cast<std::size_t>(session.look.selection.unit);
    for (std::size_t i = 0; model && i < model->units[number].matrix.size(); ++i)
        places.push_back(
            {Section::Matrix,
             Sentence("Matrix step {0} of the model", i + 1),
             {&model->units[number].matrix[i], &initialStep,
              fmt::format("{}.{}.{}",
                          elementOf<&Scene::models>(static_cast<std::size_t>(session.look.selection.model)),
                          elementOf<&Model::units>(number), elementOf<&ModelUnit::matrix>(i))},
             &stepTable(model->units[number].matrix[i].op)});
}

void addModelPlaces(Places& places, const Session& session) {
    static const Model initial;
    const Model* model = selectedModel(session);
    if (!model)
        return;
    const std::string path =
        elementOf<&Scene::models>(static_cast<std::size_t>(session.look.selection.model));
    add(places, Section::Model, N_("Model"), *model, initial, path, modelTable());
    if (model->ownMaterial)
        add(places, Section::Model, N_("Material of the model"), model->material, initial.material,
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
        switchUnit(session, session.look.selection.unit, std::get<bool>(value)); // with a texture
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
    if (boundTexture(session)) {
        places.push_back({Section::Texture, "", textureOwner(session), &textureTable()});
        places.push_back({Section::Texture, N_("Upload"), uploadOwner(session), &uploadTable()});
    }
    addUnitPlaces(places, session);
    const std::string pass = elementOf<&Scene::passes>(static_cast<std::size_t>(session.look.selection.pass));
    add(places, Section::Pass, "", selectedPass(session), initialPass, pass, passTable());
    add(places, Section::Pass, N_("Fog"), selectedPass(session).fog, initialPass.fog,
        fmt::format("{}.{}", pass, keyOf<&Pass::fog>()), fogTable());
    add(places, Section::Light, "", scene.light, initial.light, keyOf<&Scene::light>(), lightTable());
    add(places, Section::Light, N_("Projector"), scene.light.projector, initial.light.projector,
        pathOf<&Scene::light, &Light::projector>(), projectorTable());
    places.push_back({Section::Material, N_("Material"), materialOwner(session), &materialTable()});
    addModelPlaces(places, session);
    add(places, Section::View, N_("Camera"), scene.view, start, keyOf<&Scene::view>(), viewTable());
    return places;
}

std::vector<ShownStruct> shownStructs(const Session& session, Section section) {
    std::vector<ShownStruct> places = shownStructs(session);
    std::erase_if(places, [section](const ShownStruct& place) { return place.section != section; });
    return places;
}

} // namespace texplorer::ui
