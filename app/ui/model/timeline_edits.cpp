#include "app/ui/model/timeline_edits.h"

#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/scene_at.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr double keysPerSecond = 100;

void sayNotAdded(const Session& session, const Error& error) {
    act(session, [text = Sentence("A key frame can't be added: {0}.", describe(error))](Session& told) {
        say(told, text);
    });
}

} // namespace

float presentKeyTime(const Session& session) {
    const double time = std::round(session.look.playback.time * keysPerSecond) / keysPerSecond;
    return static_cast<float>(std::clamp(time, 0.0, double{maxKeyTime}));
}

void holdTime(Session& session) {
    goToTime(session, double{presentKeyTime(session)});
}

void goToTime(Session& session, double seconds) {
    session.look.playback.playing = false;
    session.look.playback.time = std::max(0.0, seconds);
}

void goToKey(Session& session, int direction) {
    const double now = session.look.playback.time;
    std::optional<double> nearest;
    for (const KeyFrame& key : presentScene(session).timeline.keys) {
        const double time = double{key.time};
        const bool isAhead = direction > 0 ? time > now : time < now;
        if (isAhead && (!nearest || std::abs(time - now) < std::abs(*nearest - now)))
            nearest = time;
    }
    if (nearest)
        goToTime(session, *nearest);
}

void addKey(const Session& session, std::string_view path, float time) {
    Scene scene = presentScene(session);
    const Result<std::string> value = getParam(sceneAt(scene, double{time}), path);
    const Result<std::size_t> added =
        value ? putKey(scene, path, time, *value) : Result<std::size_t>(fail(value.error()));
    if (!added)
        return sayNotAdded(session, added.error());
    submit(
        session, "Add key frame", [&](Scene& changed) { changed.timeline = std::move(scene.timeline); },
        std::string(path));
}

void turnView(Session& session) {
    constexpr float turn = 360;
    constexpr float seconds = 4;
    const std::string path = pathOf<&Scene::view, &View::azimuth>();
    const float now = presentScene(session).view.azimuth;
    const float then = now > 0 ? now - turn : now + turn; // the range ends at one turn
    Scene scene = presentScene(session);
    for (const auto& [time, value] : {std::pair{0.0F, now}, std::pair{seconds, then}}) {
        if (const Result<std::size_t> added = putKey(scene, path, time, formatNumber(value)); !added)
            return sayNotAdded(session, added.error());
    }
    submit(
        session, "Turn the view", [&](Scene& changed) { changed.timeline = std::move(scene.timeline); },
        path);
    session.look.playback.time = 0;
    session.look.playback.playing = true;
}

void removeKey(const Session& session, std::size_t key) {
    const std::vector<KeyFrame>& keys = presentScene(session).timeline.keys;
    if (key >= keys.size())
        return;
    submit(
        session, "Remove key frame",
        [key](Scene& scene) {
            scene.timeline.keys.erase(scene.timeline.keys.begin() + static_cast<std::ptrdiff_t>(key));
        },
        keys[key].path);
}

void removeKeys(const Session& session, std::string_view path) {
    submit(
        session, "Remove key frames",
        [path = std::string(path)](Scene& scene) { dropKeys(scene.timeline, path); }, std::string(path));
}

bool moveKey(const Session& session, std::size_t key, float time) {
    const std::vector<KeyFrame>& keys = presentScene(session).timeline.keys;
    const float wanted = std::clamp(time, 0.0F, maxKeyTime);
    if (key >= keys.size() || keys[key].time == wanted)
        return false;
    submitDrag(
        session, N_("Move key frame"), [&](Scene& scene) { scene.timeline.keys[key].time = wanted; },
        keys[key].path);
    return true;
}

void setEasing(const Session& session, std::size_t key, Easing easing) {
    const std::vector<KeyFrame>& keys = presentScene(session).timeline.keys;
    if (key < keys.size())
        submit(
            session, "Easing", [&](Scene& scene) { scene.timeline.keys[key].easing = easing; },
            keys[key].path);
}

} // namespace texplorer::ui
