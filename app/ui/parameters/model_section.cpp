#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "texplorer/base/translatable.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

/// What adds a copy of the selected model next to it; the first model is a cube. Passes that name the
/// selected model draw the new one as well.
std::vector<Edit> addedModel(const Session& session) {
    const Scene& scene = presentScene(session);
    const std::string list = keyOf<&Scene::models>();
    const auto chosen = static_cast<std::size_t>(session.look.selection.model);
    if (chosen >= scene.models.size())
        return {edit::Insert{list, 0}};
    const Model& model = scene.models[chosen];
    const ParamRow& row = *findParam(modelTable(), keyOf<&Model::position>());
    glm::vec3 position = model.position;
    position.x = std::clamp(position.x + 2.5F * model.size * model.scale.x, row.range.min, row.range.max);
    const std::string added = elementOf<&Scene::models>(chosen + 1) + ".";
    std::vector<Edit> edits{editOf(ListEdit::Add, list, chosen),
                            edit::Set{added + keyOf<&Model::visible>(), "true"},
                            edit::Set{added + keyOf<&Model::position>(), formatValue(row, position)}};
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        std::vector<int> named = scene.passes[i].models;
        for (int& each : named)
            each += std::cmp_greater(each, chosen) ? 1 : 0;
        const auto like = std::ranges::find(named, static_cast<int>(chosen));
        if (like == named.end())
            continue;
        named.insert(like + 1, static_cast<int>(chosen) + 1);
        edits.emplace_back(
            edit::Set{fmt::format("{}.{}", elementOf<&Scene::passes>(i), keyOf<&Pass::models>()),
                      fmt::format("{}", fmt::join(named, ","))});
    }
    return edits;
}

/// A mesh is shown as a summary: the Vertices tab edits it.
void meshRows(const Session& session, const Owner& owner, const MeshData& mesh) {
    paramWidget(session, owner, *findParam(meshTable(), keyOf<&MeshData::primitive>()));
    paramWidget(session, owner, *findParam(meshTable(), keyOf<&MeshData::file>()));
    if (!mesh.file.empty())
        paramWidget(session, owner, *findParam(meshTable(), keyOf<&MeshData::part>()));
    const std::size_t vertices = mesh.positions.size();
    const std::size_t indices = mesh.indices.size();
    std::vector<Sentence> lists{Sentence::plural("{0} vertex", "{0} vertices", vertices)};
    const auto add = [&](bool there, Sentence what) {
        if (there)
            lists.push_back(std::move(what));
    };
    add(!mesh.normals.empty(), N_("normals"));
    add(!mesh.colors.empty(), N_("colours"));
    add(!mesh.texCoords.empty(), N_("coordinates"));
    add(indices > 0, Sentence::plural("{0} index", "{0} indices", indices));
    dimText(Sentence::joined("{0}, {1}", lists));
    helpTip("The Vertices tab edits them one by one. Texture space moves their coordinates.");
}

void editModels(const Session& session, std::size_t count) {
    constexpr ListWords words{"model",
                              N_("Add a copy of this model after it"),
                              N_("Draw this model earlier"),
                              N_("Draw this model later"),
                              N_("Remove this model"),
                              N_("Add model"),
                              N_("Reorder models"),
                              N_("Remove model")};
    const auto chosen = static_cast<std::size_t>(session.look.selection.model);
    const auto pressed = listButtons(words, chosen, count, 0, maxModels);
    if (!pressed)
        return;
    submit(session, {.name = words.nameOf(*pressed),
                     .edits = pressed == ListEdit::Add
                                  ? addedModel(session)
                                  : std::vector{editOf(*pressed, keyOf<&Scene::models>(), chosen)}});
}

} // namespace

void modelSection(const Session& session) {
    const std::size_t count = presentScene(session).models.size();
    ImGui::AlignTextToFramePadding();
    if (count == 0)
        dimText("No model");
    else
        dimText(Sentence("Model {0}", session.look.selection.model));
    editModels(session, count);
    if (presentScene(session).models.empty())
        return;
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    modelChoice(session, width, width);
    static const MeshData initial;
    const Model& model = *selectedModel(session);
    const std::vector<ShownStruct> places = shownStructs(session, Section::Model);
    if (model.shape == Shape::Mesh)
        meshRows(
            session,
            {&model.mesh, &initial, fmt::format("{}.{}", places.front().owner.path, keyOf<&Model::mesh>())},
            model.mesh);
    RowOptions options;
    options.leavesOut = [](const ParamRow& row) { // it is with the steps
        return row.member == memberId<&Model::pushMatrix>;
    };
    for (const ShownStruct& place : places) // the model and its own material
        paramRows(session, place.owner, *place.table, options);
}

} // namespace texplorer::ui
