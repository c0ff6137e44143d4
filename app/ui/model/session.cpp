#include "app/ui/model/session.h"

#include "app/ui/view/camera.h"
#include "core/base/printable.h"
#include "core/scene/animation.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

int lastIndex(std::size_t size) {
    return std::max(0, static_cast<int>(size) - 1);
}

} // namespace

Session::Session(Scene start, ImageSource source)
    : scene(start)
    , history(start)
    , saved(std::move(start))
    , images(std::move(source))
    , levelsAtOnce(std::make_shared<LevelsWorker>(LevelsWorker::When::AtOnce))
    , referenceAtOnce(std::make_shared<reference::DrawWorker>(reference::DrawWorker::When::AtOnce))
    , probeWorkerAtOnce(std::make_shared<reference::ProbeWorker>(reference::ProbeWorker::When::AtOnce)) {}

namespace {

/// What one sees is what the lists should be about.
void leaveHiddenModel(Session& session) {
    const std::vector<Model>& models = session.scene.models;
    const Model* selected = selectedModel(session);
    const auto visible = std::ranges::find(models, true, &Model::visible);
    if (visible == models.end() || (selected && selected->visible))
        return;
    session.selection.model = static_cast<int>(visible - models.begin());
    session.selection.vertex.reset();
}

} // namespace

Session makeSession(Scene scene, ImageSource images, std::filesystem::path file) {
    Session session(std::move(scene), std::move(images));
    session.needsFit = file.empty() || session.scene.view == defaultScene().view;
    session.file = std::move(file);
    leaveHiddenModel(session);
    return session;
}

void settle(Session& session, const Layout& layout) {
    if (session.needsFit) {
        const float aspect =
            static_cast<float>(layout.picture.width) / static_cast<float>(std::max(1, layout.picture.height));
        const bool untouched = session.scene == session.saved && !session.history.canUndo();
        fitDistance(session.scene, session.playback.time, aspect);
        session.needsFit = false;
        if (untouched) { // how the program begins is not an edit
            session.saved = session.scene;
            session.history = History(session.scene);
        }
    }
    Selection& selection = session.selection;
    const Scene& scene = session.scene;
    selection.model = std::clamp(selection.model, 0, lastIndex(scene.models.size()));
    selection.pass = std::clamp(selection.pass, 0, lastIndex(scene.passes.size()));
    selection.unit = std::clamp(selection.unit, 0, maxUnits - 1);
    if (selection.vertex && *selection.vertex >= selectedMesh(session).vertices.size())
        selection.vertex.reset();
}

bool isMoving(const Session& session) {
    return session.playback.playing && session.playback.speed != 0 && isAnimated(session.scene);
}

void advance(Session& session, double seconds) {
    if (isMoving(session))
        session.playback.time =
            std::max(0.0, session.playback.time + seconds * static_cast<double>(session.playback.speed));
}

void recordEdit(Session& session, std::string_view what, std::string_view path) {
    session.history.record(session.scene, what);
    session.lastChanged = path;
}

void sealEdit(Session& session) {
    session.history.seal();
}

void undo(Session& session) {
    if (session.history.canUndo())
        session.scene = session.history.undo();
    leaveHiddenModel(session);
    session.lastChanged.clear();
}

void redo(Session& session) {
    if (session.history.canRedo())
        session.scene = session.history.redo();
    leaveHiddenModel(session);
    session.lastChanged.clear();
}

bool isDirty(const Session& session) {
    if (!session.file.empty())
        return session.scene != session.saved;
    const Scene& a = session.scene;
    const Scene& b = session.saved;
    return a.light != b.light || a.material != b.material || a.models != b.models ||
           a.textures != b.textures || a.passes != b.passes;
}

std::string windowTitle(const Session& session) {
    const std::string name = session.file.empty() ? "Untitled" : session.file.filename().string();
    return printable(name) + (isDirty(session) ? " • Texplorer" : " - Texplorer");
}

LevelsWorker& levelsOf(Session& session) {
    return session.background ? session.background->levels : *session.levelsAtOnce;
}

reference::DrawWorker& referenceOf(Session& session) {
    return session.background ? session.background->reference : *session.referenceAtOnce;
}

reference::ProbeWorker& probeWorkerOf(Session& session) {
    return session.background ? session.background->probe : *session.probeWorkerAtOnce;
}

Model* selectedModel(Session& session) {
    const auto index = static_cast<std::size_t>(session.selection.model);
    return index < session.scene.models.size() ? &session.scene.models[index] : nullptr;
}

const Mesh& selectedMesh(Session& session) {
    static const Mesh none;
    const Model* model = selectedModel(session);
    if (!model)
        return none;
    const std::array<int, 3> key{static_cast<int>(model->shape), model->slices, model->stacks};
    if (!session.mesh || session.meshKey != key) {
        session.mesh = std::make_shared<const Mesh>(makeMesh(model->shape, model->slices, model->stacks));
        session.meshKey = key;
    }
    return *session.mesh;
}

Pass& selectedPass(Session& session) {
    return session.scene.passes[static_cast<std::size_t>(session.selection.pass)];
}

Unit& selectedUnit(Session& session) {
    return selectedPass(session).units[static_cast<std::size_t>(session.selection.unit)];
}

std::string selectedUnitPath(const Session& session) {
    return "passes[" + std::to_string(session.selection.pass) + "].units[" +
           std::to_string(session.selection.unit) + "]";
}

const Texture* boundTexture(const Session& session) {
    const Scene& scene = session.scene;
    const auto pass = static_cast<std::size_t>(session.selection.pass);
    if (pass >= scene.passes.size())
        return nullptr;
    const int index = scene.passes[pass].units[static_cast<std::size_t>(session.selection.unit)].texture;
    const bool exists = index >= 0 && static_cast<std::size_t>(index) < scene.textures.size();
    return exists ? &scene.textures[static_cast<std::size_t>(index)] : nullptr;
}

Texture* boundTexture(Session& session) {
    return const_cast<Texture*>(boundTexture(std::as_const(session)));
}

} // namespace texplorer::ui
