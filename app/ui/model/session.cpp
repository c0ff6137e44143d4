#include "app/ui/model/session.h"

#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_at.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

int lastIndex(std::size_t size) {
    return std::max(0, static_cast<int>(size) - 1);
}

} // namespace

Session::Session(Services lent, Document start)
    : services(lent)
    , document(std::move(start)) {
    showPresent(*this);
    leaveHiddenModel(*this);
}

void leaveHiddenModel(Session& session) {
    const std::vector<Model>& models = presentScene(session).models;
    const Model* selected = selectedModel(session);
    const auto visible = std::ranges::find(models, true, &Model::visible);
    if (visible == models.end() || (selected && selected->visible))
        return;
    session.look.selection.model = static_cast<int>(visible - models.begin());
    session.look.selection.vertex.reset();
}

void bringSelectionBack(Session& session) {
    Selection& selection = session.look.selection;
    const Scene& scene = session.document.scene;
    selection.model = std::clamp(selection.model, 0, lastIndex(scene.models.size()));
    selection.pass = std::clamp(selection.pass, 0, lastIndex(scene.passes.size()));
    selection.unit = std::clamp(selection.unit, 0, maxUnits - 1);
    if (selection.vertex && *selection.vertex >= selectedMesh(session).vertices.size())
        selection.vertex.reset();
    std::erase_if(selection.group.vertices,
                  [&session](std::size_t vertex) { return vertex >= selectedMesh(session).vertices.size(); });
}

Step stepThat(const Session& session, Sentence name, const std::function<void(Scene&)>& change,
              std::string path) {
    Step step{.name = std::move(name), .path = std::move(path)};
    if (std::optional<Edit> edit = editThat(presentScene(session), change))
        step.edits.push_back(std::move(*edit));
    return step;
}

void act(const Session& session, Action action) {
    session.out.requests.emplace_back(std::move(action));
}

void rearrange(const Session& session, std::function<void(Workspace&)> make) {
    act(session, [make = std::move(make)](Session& changed) { make(changed.settings.workspace); });
}

void ask(const Session& session, std::function<bool(Session&)> question) {
    act(session,
        [asked = std::move(question)](Session& changed) { changed.out.isOutdated |= asked(changed); });
}

void submit(const Session& session, Step step) {
    if (!step.edits.empty() || step.select)
        session.out.requests.emplace_back(std::move(step));
}

void submit(const Session& session, Sentence name, const std::function<void(Scene&)>& change,
            std::string path) {
    submit(session, stepThat(session, std::move(name), change, std::move(path)));
}

void submitDrag(const Session& session, Sentence name, const std::function<void(Scene&)>& change,
                std::string path) {
    Step step = stepThat(session, std::move(name), change, std::move(path));
    step.continues = true;
    submit(session, std::move(step));
}

void sealEdit(const Session& session) {
    session.out.requests.emplace_back(EndStep{});
}

void resetToSaved(const Session& session) {
    submit(session,
           {.name = session.document.file.empty() ? N_("Reset to the start") : N_("Reset to the file"),
            .edits = {edit::Replace{std::make_shared<const Scene>(session.document.saved)}},
            .select = session.look.selection});
}

const Scene& presentScene(const Session& session) {
    return session.document.present ? *session.document.present : session.document.scene;
}

void showPresent(Session& session) {
    const Scene& scene = session.document.scene;
    if (scene.timeline.keys.empty())
        return session.document.present.reset();
    Scene present = sceneAt(scene, session.look.playback.time);
    present.timeline = scene.timeline;
    session.document.present = std::move(present);
}

const Model* selectedModel(const Session& session) {
    const std::vector<Model>& models = presentScene(session).models;
    const auto index = static_cast<std::size_t>(session.look.selection.model);
    return index < models.size() ? &models[index] : nullptr;
}

Model& selectedModel(Scene& scene, const Selection& selection) {
    return scene.models[static_cast<std::size_t>(selection.model)];
}

const Mesh& selectedMesh(const Session& session) {
    static const Mesh none;
    const Model* model = selectedModel(session);
    if (!model)
        return none;
    MeshOfModel& made = session.mesh;
    const bool own = model->shape == Shape::Mesh;
    if (!made.mesh || made.shape != shapeOptions(*model) || (own && made.data != model->mesh))
        made = {std::make_shared<const Mesh>(meshOf(*model)), shapeOptions(*model),
                own ? model->mesh : MeshData{}};
    return *made.mesh;
}

const Pass& selectedPass(const Session& session) {
    return presentScene(session).passes[static_cast<std::size_t>(session.look.selection.pass)];
}

Unit& selectedUnit(Scene& scene, const Selection& selection) {
    return scene.passes[static_cast<std::size_t>(selection.pass)]
        .units[static_cast<std::size_t>(selection.unit)];
}

const Unit& selectedUnit(const Session& session) {
    return selectedPass(session).units[static_cast<std::size_t>(session.look.selection.unit)];
}

std::string selectedUnitPath(const Session& session) {
    return unitPath(session.look.selection);
}

std::string unitPath(const Selection& selection) {
    return fmt::format("passes[{}].units[{}]", selection.pass, selection.unit);
}

const Texture* textureOf(const Scene& scene, const Unit& unit) {
    const bool exists = unit.texture >= 0 && static_cast<std::size_t>(unit.texture) < scene.textures.size();
    return exists ? &scene.textures[static_cast<std::size_t>(unit.texture)] : nullptr;
}

const Texture* boundTexture(const Session& session) {
    const Scene& scene = presentScene(session);
    const bool hasPass = static_cast<std::size_t>(session.look.selection.pass) < scene.passes.size();
    return hasPass ? textureOf(scene, selectedUnit(session)) : nullptr;
}

std::shared_ptr<const TextureImage> boundImage(const Session& session) {
    const Texture* texture = boundTexture(session);
    return texture ? session.document.images.find(*texture) : nullptr;
}

} // namespace texplorer::ui
