#include "app/ui/model/session.h"

#include "app/ui/model/camera.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/loads.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/timeline_edits.h"
#include "core/lesson/numbers.h"
#include "core/scene/animation.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/key_edits.h"
#include "core/scene/params/keys.h"
#include "core/scene/params/params.h"
#include "core/scene/params/scene_diff.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

bool isPlaying(const Session& session) {
    return session.window.playback.playing && session.window.playback.speed != 0 &&
           isAnimated(shownScene(session));
}

int lastIndex(std::size_t size) {
    return std::max(0, static_cast<int>(size) - 1);
}

/// A fitted camera that the user has not moved fills its picture when the picture's shape changes. This is
/// not an edit: steps of the history and the saved scene with the same camera are changed as well.
void followShape(Document& document, double time, float aspect) {
    const Fit& fit = document.fit;
    const bool follows = fit.aspect > 0 && fit.aspect != aspect && document.scene.view == fit.view;
    if (!document.needsFit && !follows)
        return;
    const View before = document.scene.view;
    fitDistance(document.scene, time, aspect);
    document.needsFit = false;
    document.fit = {document.scene.view, aspect};
    document.history.replaceView(before, document.scene.view);
    if (document.saved.view == before)
        document.saved.view = document.scene.view;
}

void showStep(Session& session, const Scene& scene) {
    session.document.standing.reset();
    session.document.scene = scene;
    leaveHiddenModel(session);
    bringSelectionBack(session);
    session.document.lastChanged.clear();
}

/// Places a lesson's mark in the picture of any size.
void placeMark(Session& session, lesson::PictureSize picture) {
    std::optional<WantedProbe>& wanted = session.window.wantedProbe;
    std::optional<reference::PixelPlace>& explained = session.window.explaining.pixel;
    const bool isLeft = wanted && wanted->pixel && explained != wanted->pixel; // for another one, or none
    if (isLeft || !session.window.lesson)
        wanted.reset();
    if (wanted)
        explained = wanted->pixel = lesson::pixelOf(wanted->x, wanted->y, picture);
}

std::size_t lengthOf(Scene& scene, const std::string& list) {
    const Result<ListAt> found = listAt(scene, list);
    return found ? found->size() : 0;
}

} // namespace

Session::Session(Services lent, Document start)
    : services(lent)
    , document(std::move(start)) {
    leaveHiddenModel(*this);
}

void leaveHiddenModel(Session& session) {
    const std::vector<Model>& models = session.document.scene.models;
    const Model* selected = selectedModel(session);
    const auto visible = std::ranges::find(models, true, &Model::visible);
    if (visible == models.end() || (selected && selected->visible))
        return;
    session.window.selection.model = static_cast<int>(visible - models.begin());
    session.window.selection.vertex.reset();
}

void replaceDocument(Session& session, Document document) {
    WindowState& window = session.window;
    if (window.fileView.ticket != 0)
        session.services.files.cancel(window.fileView.ticket);
    static_cast<DocumentLook&>(window) = {};
    static_cast<ShownPart&>(window.view) = {};
    static_cast<RecordedTime&>(window.recording) = {};
    if (window.lesson && !document.isLessons)
        closeLesson(session);
    endLessonPictures(window);
    exchangeDocument(session, std::move(document));
}

void exchangeDocument(Session& session, Document document) {
    cancelLoads(session);
    session.steps.clear(); // they are for the other document
    session.document = std::move(document);
    ++session.documents;
    leaveHiddenModel(session);
    bringSelectionBack(session);
}

void endLessonPictures(WindowState& window) {
    const std::optional<LessonPictures> lesson = std::exchange(window.lessonPictures, std::nullopt);
    if (lesson && static_cast<ShownPictures&>(window.view) == lesson->chosen)
        static_cast<ShownPictures&>(window.view) = lesson->before;
}

void bringSelectionBack(Session& session) {
    Selection& selection = session.window.selection;
    const Scene& scene = session.document.scene;
    selection.model = std::clamp(selection.model, 0, lastIndex(scene.models.size()));
    selection.pass = std::clamp(selection.pass, 0, lastIndex(scene.passes.size()));
    selection.unit = std::clamp(selection.unit, 0, maxUnits - 1);
    if (selection.vertex && *selection.vertex >= selectedMesh(session).vertices.size())
        selection.vertex.reset();
    std::erase_if(selection.group.vertices,
                  [&session](std::size_t vertex) { return vertex >= selectedMesh(session).vertices.size(); });
}

void settle(Session& session, const Layout& layout) {
    followShape(session.document, session.window.playback.time, aspectOf(layout));
    bringSelectionBack(session);
    followKept(session);
    placeMark(session, {layout.picture.width, layout.picture.height});
}

bool isMoving(const Session& session) {
    return isPlaying(session) || (session.window.lesson && session.window.lesson->holdsKey);
}

void advance(Session& session, double seconds) {
    if (!isPlaying(session))
        return;
    Playback& playback = session.window.playback;
    playback.time = std::max(0.0, playback.time + seconds * static_cast<double>(playback.speed));
    const double length = lengthOf(session.document.scene.timeline);
    if (playback.loops && length > 0 && playback.time > length)
        playback.time = std::fmod(playback.time, length);
}

void recordEdit(Session& session, std::string_view what, std::string_view path) {
    Document& document = session.document;
    const Scene& before = document.standing ? document.standing->shown : document.history.current();
    const Result<bool> keyed = keyEdits(document.scene, before, presentKeyTime(session));
    if (!keyed)
        say(session, fmt::format("A key frame can't be added: {}.", describe(keyed.error())));
    else if (*keyed)
        holdTime(session);
    recordScene(session, what, path);
}

void recordScene(Session& session, std::string_view what, std::string_view path) {
    Document& document = session.document;
    if (session.window.notice.isGood)
        session.window.notice = {}; // messages about earlier actions are out of date
    if (document.standing) {
        Standing& standing = *document.standing;
        standing.shown = document.scene;
        Scene recorded = document.scene;
        putUnkeyed(recorded, standing.base);
        standing.base = std::move(recorded);
        document.history.record(standing.base, what);
    } else {
        document.history.record(document.scene, what);
    }
    document.lastChanged = path;
}

void submit(Session& session, Step step) {
    session.steps.push_back(std::move(step));
}

void submit(Session& session, std::string name, const std::function<void(Scene&)>& change, std::string path) {
    Scene& scene = session.document.scene;
    auto changed = std::make_shared<Scene>(scene);
    change(*changed);
    Step step{.name = std::move(name), .path = std::move(path)};
    for (SceneChange& each : changesBetween(scene, *changed)) {
        const std::size_t before = each.isLength ? lengthOf(scene, each.path) : 0;
        const std::size_t now = each.isLength ? lengthOf(*changed, each.path) : 0;
        for (std::size_t i = before; i > now; --i) // with the key frames of what is removed
            step.edits.emplace_back(edit::Remove{each.path, i - 1});
        if (before <= now)
            step.edits.emplace_back(edit::Replace{changed, std::move(each.path)});
    }
    if (!step.edits.empty())
        submit(session, std::move(step));
}

void sealEdit(Session& session) {
    if (session.steps.empty())
        session.document.history.seal();
    else
        submit(session, {}); // without edits: see takeSteps
}

void undo(Session& session) {
    if (session.document.history.canUndo())
        goToStep(session, session.document.history.position() - 1);
}

void redo(Session& session) {
    if (session.document.history.canRedo())
        goToStep(session, session.document.history.position() + 1);
}

void takeBackEdit(Session& session) {
    showStep(session, session.document.history.takeBack());
}

void goToStep(Session& session, std::size_t step) {
    showStep(session, session.document.history.goTo(step));
}

void resetToSaved(Session& session) {
    endStanding(session);
    session.document.scene = session.document.saved;
    sealEdit(session);
    recordScene(session, session.document.file.empty() ? "Reset to the start" : "Reset to the file");
    sealEdit(session);
    leaveHiddenModel(session);
    bringSelectionBack(session);
}

Model* selectedModel(Session& session) {
    const auto index = static_cast<std::size_t>(session.window.selection.model);
    return index < session.document.scene.models.size() ? &session.document.scene.models[index] : nullptr;
}

const Mesh& selectedMesh(Session& session) {
    static const Mesh none;
    const Model* model = selectedModel(session);
    if (!model)
        return none;
    WindowState& window = session.window;
    const bool own = model->shape == Shape::Mesh;
    if (!window.mesh || window.meshShape != shapeOptions(*model) || (own && window.meshData != model->mesh)) {
        window.mesh = std::make_shared<const Mesh>(meshOf(*model));
        window.meshShape = shapeOptions(*model);
        window.meshData = own ? model->mesh : MeshData{};
    }
    return *session.window.mesh;
}

Pass& selectedPass(Session& session) {
    return session.document.scene.passes[static_cast<std::size_t>(session.window.selection.pass)];
}

Unit& selectedUnit(Scene& scene, const Selection& selection) {
    return scene.passes[static_cast<std::size_t>(selection.pass)]
        .units[static_cast<std::size_t>(selection.unit)];
}

Unit& selectedUnit(Session& session) {
    return selectedUnit(session.document.scene, session.window.selection);
}

std::string selectedUnitPath(const Session& session) {
    return fmt::format("passes[{}].units[{}]", session.window.selection.pass, session.window.selection.unit);
}

const Texture* boundTexture(const Session& session) {
    const Scene& scene = session.document.scene;
    const auto pass = static_cast<std::size_t>(session.window.selection.pass);
    if (pass >= scene.passes.size())
        return nullptr;
    const int index =
        scene.passes[pass].units[static_cast<std::size_t>(session.window.selection.unit)].texture;
    const bool exists = index >= 0 && static_cast<std::size_t>(index) < scene.textures.size();
    return exists ? &scene.textures[static_cast<std::size_t>(index)] : nullptr;
}

Texture* boundTexture(Session& session) {
    return const_cast<Texture*>(boundTexture(std::as_const(session)));
}

} // namespace texplorer::ui
