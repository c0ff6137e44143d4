#include "app/ui/parameters/model_section.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/explaining.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "core/scene/drawn_models.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace texplorer::ui {
namespace {

void modelListChanged(Session& session, int chosen, std::string_view what) {
    session.window.selection.model = chosen;
    session.window.selection.vertex.reset();
    sealEdit(session);
    recordEdit(session, what);
    sealEdit(session);
    clearTexel(session); // its texel may belong to another model
}

/// Adds a copy of the selected model next to it; the first model is a cube. Passes that name the selected
/// model draw the new one as well.
void addModel(Session& session) {
    Scene& scene = session.document.scene;
    const auto chosen = static_cast<std::size_t>(session.window.selection.model);
    Model model;
    std::size_t at = 0;
    if (chosen < scene.models.size()) {
        model = scene.models[chosen];
        model.visible = true;
        const Range& range = findParam(modelTable(), keyOf<&Model::position>())->range;
        model.position.x =
            std::clamp(model.position.x + 2.5F * model.size * model.scale.x, range.min, range.max);
        at = chosen + 1;
    }
    scene.models.insert(scene.models.begin() + static_cast<std::ptrdiff_t>(at), model);
    modelInserted(scene, at);
    for (Pass& pass : scene.passes) {
        const auto like = std::ranges::find(pass.models, static_cast<int>(chosen));
        if (like != pass.models.end())
            pass.models.insert(like + 1, static_cast<int>(at));
    }
    modelListChanged(session, static_cast<int>(at), "Add model");
}

void removeModel(Session& session) {
    Scene& scene = session.document.scene;
    const auto chosen = static_cast<std::size_t>(session.window.selection.model);
    scene.models.erase(scene.models.begin() + static_cast<std::ptrdiff_t>(chosen));
    modelRemoved(scene, chosen);
    const int last = std::max(0, static_cast<int>(scene.models.size()) - 1);
    modelListChanged(session, std::min(static_cast<int>(chosen), last), "Remove model");
}

void moveModel(Session& session, int by) {
    Scene& scene = session.document.scene;
    const int chosen = session.window.selection.model;
    const auto from = static_cast<std::size_t>(chosen);
    const auto to = static_cast<std::size_t>(chosen + by);
    std::swap(scene.models[from], scene.models[to]);
    modelsSwapped(scene, from, to);
    modelListChanged(session, chosen + by, "Reorder models");
}

/// A mesh is shown as a summary: the Vertices tab edits it.
void meshRows(Session& session, const Owner& owner, const MeshData& mesh) {
    paramWidget(session, owner, *findParam(meshTable(), keyOf<&MeshData::primitive>()));
    const std::size_t vertices = mesh.positions.size();
    const std::size_t indices = mesh.indices.size();
    std::string lists = vertices == 1 ? tr("1 vertex") : tr(fmt::format("{} vertices", vertices));
    const auto add = [&](bool there, const std::string& what) {
        if (there)
            lists += ", " + what;
    };
    add(!mesh.normals.empty(), tr("normals"));
    add(!mesh.colors.empty(), tr("colours"));
    add(!mesh.texCoords.empty(), tr("coordinates"));
    add(indices > 0, indices == 1 ? tr("1 index") : tr(fmt::format("{} indices", indices)));
    dimText(lists);
    helpTip("The Vertices tab edits them one by one. Texture space moves their coordinates.");
}

void editModels(Session& session, std::size_t count) {
    constexpr ListWords words{"model", "Add a copy of this model after it", "Draw this model earlier",
                              "Draw this model later", "Remove this model"};
    const auto pressed =
        listButtons(words, static_cast<std::size_t>(session.window.selection.model), count, 0, maxModels);
    if (pressed == ListEdit::Add)
        addModel(session);
    else if (pressed == ListEdit::Up)
        moveModel(session, -1);
    else if (pressed == ListEdit::Down)
        moveModel(session, 1);
    else if (pressed == ListEdit::Remove)
        removeModel(session);
}

} // namespace

void modelSection(Session& session) {
    const std::size_t count = session.document.scene.models.size();
    ImGui::AlignTextToFramePadding();
    if (count == 0)
        dimText("No model");
    else
        dimText(fmt::format("Model {}", session.window.selection.model));
    editModels(session, count);
    if (session.document.scene.models.empty())
        return;
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    modelChoice(session, width, width);
    static const Model initial;
    Model& model = *selectedModel(session);
    const std::string path =
        elementOf<&Scene::models>(static_cast<std::size_t>(session.window.selection.model));
    if (model.shape == Shape::Mesh)
        meshRows(session, {&model.mesh, &initial.mesh, fmt::format("{}.{}", path, keyOf<&Model::mesh>())},
                 model.mesh);
    paramRows(session, {&model, &initial, path}, modelTable());
    if (model.ownMaterial)
        paramRows(session,
                  {&model.material, &initial.material, fmt::format("{}.{}", path, keyOf<&Model::material>())},
                  modelMaterialTable());
}

} // namespace texplorer::ui
