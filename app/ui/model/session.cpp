#include "app/ui/model/session.h"

#include "app/ui/model/camera.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/loads.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/scene_files.h"
#include "core/lesson/numbers.h"
#include "core/scene/animation.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/keys.h"
#include "core/scene/params/params.h"
#include "core/scene/params/scene_at.h"

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
    std::erase_if(session.out.requests, [](const Request& each) { // they are for the other document
        return !std::holds_alternative<Action>(each);
    });
    session.document = std::move(document);
    ++session.documents;
    showPresent(session);
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
    showPresent(session);
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

Step stepThat(const Session& session, std::string name, const std::function<void(Scene&)>& change,
              std::string path) {
    Step step{.name = std::move(name), .path = std::move(path)};
    if (std::optional<Edit> edit = editThat(presentScene(session), change))
        step.edits.push_back(std::move(*edit));
    return step;
}

void act(const Session& session, Action action) {
    session.out.requests.emplace_back(std::move(action));
}

void change(const Session& session, std::function<void(WindowState&)> make) {
    act(session, [make = std::move(make)](Session& changed) { make(changed.window); });
}

void rearrange(const Session& session, std::function<void(Workspace&)> make) {
    change(session, [make = std::move(make)](WindowState& window) { make(window.settings.workspace); });
}

void submit(const Session& session, Step step) {
    if (!step.edits.empty() || step.select)
        session.out.requests.emplace_back(std::move(step));
}

void submit(const Session& session, std::string name, const std::function<void(Scene&)>& change,
            std::string path) {
    submit(session, stepThat(session, std::move(name), change, std::move(path)));
}

void submitDrag(const Session& session, std::string name, const std::function<void(Scene&)>& change,
                std::string path) {
    Step step = stepThat(session, std::move(name), change, std::move(path));
    step.continues = true;
    submit(session, std::move(step));
}

void sealEdit(const Session& session) {
    session.out.requests.emplace_back(EndStep{});
}

void resetToSaved(const Session& session) {
    submit(session, {.name = session.document.file.empty() ? "Reset to the start" : "Reset to the file",
                     .edits = {edit::Replace{std::make_shared<const Scene>(session.document.saved)}},
                     .select = session.window.selection});
}

const Scene& presentScene(const Session& session) {
    return session.document.present ? *session.document.present : session.document.scene;
}

void showPresent(Session& session) {
    const Scene& scene = session.document.scene;
    if (scene.timeline.keys.empty())
        return session.document.present.reset();
    Scene present = sceneAt(scene, session.window.playback.time);
    present.timeline = scene.timeline;
    session.document.present = std::move(present);
}

const Model* selectedModel(const Session& session) {
    const std::vector<Model>& models = presentScene(session).models;
    const auto index = static_cast<std::size_t>(session.window.selection.model);
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
    return presentScene(session).passes[static_cast<std::size_t>(session.window.selection.pass)];
}

Unit& selectedUnit(Scene& scene, const Selection& selection) {
    return scene.passes[static_cast<std::size_t>(selection.pass)]
        .units[static_cast<std::size_t>(selection.unit)];
}

const Unit& selectedUnit(const Session& session) {
    return selectedPass(session).units[static_cast<std::size_t>(session.window.selection.unit)];
}

std::string selectedUnitPath(const Session& session) {
    return unitPath(session.window.selection);
}

std::string unitPath(const Selection& selection) {
    return fmt::format("passes[{}].units[{}]", selection.pass, selection.unit);
}

const Texture* boundTexture(const Session& session) {
    const Scene& scene = presentScene(session);
    const auto pass = static_cast<std::size_t>(session.window.selection.pass);
    if (pass >= scene.passes.size())
        return nullptr;
    const int index =
        scene.passes[pass].units[static_cast<std::size_t>(session.window.selection.unit)].texture;
    const bool exists = index >= 0 && static_cast<std::size_t>(index) < scene.textures.size();
    return exists ? &scene.textures[static_cast<std::size_t>(index)] : nullptr;
}

} // namespace texplorer::ui
