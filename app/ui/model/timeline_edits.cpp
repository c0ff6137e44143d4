#include "app/ui/model/timeline_edits.h"

#include "app/ui/model/scene_files.h"
#include "app/ui/model/session.h"
#include "core/scene/params/key_edits.h"
#include "core/scene/params/keys.h"
#include "core/scene/params/param_text.h"
#include "core/scene/params/scene_at.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr double keysPerSecond = 100;

void recordAlone(Session& session, std::string_view what, std::string_view path) {
    sealEdit(session);
    recordScene(session, what, path);
    sealEdit(session);
}

/// A parameter without keys keeps its value at the present time.
void stayAsNow(Session& session, const std::string& path, const Scene& before) {
    Scene& scene = session.document.scene;
    if (hasKeys(scene.timeline, path))
        return;
    const Result<std::string> now = getParam(sceneAt(before, session.window.playback.time), path);
    if (now)
        static_cast<void>(putBetween(scene, path, *now, *now, 0));
}

} // namespace

void beginStanding(Session& session) {
    Document& document = session.document;
    if (document.standing || document.scene.timeline.keys.empty())
        return;
    Scene shown = sceneAt(document.scene, session.window.playback.time);
    shown.timeline = document.scene.timeline;
    document.standing = Standing{std::exchange(document.scene, shown), std::move(shown)};
}

void endStanding(Session& session) {
    Document& document = session.document;
    if (!document.standing)
        return;
    Standing standing = *std::exchange(document.standing, std::nullopt);
    if (document.scene == standing.shown)
        document.scene = std::move(standing.base);
    else
        putUnkeyed(document.scene, standing.base);
}

float presentKeyTime(const Session& session) {
    const double time = std::round(session.window.playback.time * keysPerSecond) / keysPerSecond;
    return static_cast<float>(std::clamp(time, 0.0, double{maxKeyTime}));
}

void holdTime(Session& session) {
    goToTime(session, double{presentKeyTime(session)});
}

void goToTime(Session& session, double seconds) {
    session.window.playback.playing = false;
    session.window.playback.time = std::max(0.0, seconds);
}

void goToKey(Session& session, int direction) {
    const double now = session.window.playback.time;
    std::optional<double> nearest;
    for (const KeyFrame& key : session.document.scene.timeline.keys) {
        const double time = double{key.time};
        const bool isAhead = direction > 0 ? time > now : time < now;
        if (isAhead && (!nearest || std::abs(time - now) < std::abs(*nearest - now)))
            nearest = time;
    }
    if (nearest)
        goToTime(session, *nearest);
}

void addKey(Session& session, std::string_view path, float time) {
    Scene& scene = session.document.scene;
    const Result<std::string> value = getParam(sceneAt(scene, double{time}), path);
    const Result<std::size_t> added =
        value ? putKey(scene, path, time, *value) : Result<std::size_t>(fail(value.error()));
    if (!added)
        return say(session, fmt::format("A key frame can't be added: {}.", describe(added.error())));
    recordAlone(session, "Add key frame", path);
}

void turnView(Session& session) {
    constexpr float turn = 360;
    constexpr float seconds = 4;
    const std::string path = pathOf<&Scene::view, &View::azimuth>();
    const float now = session.document.scene.view.azimuth;
    const float then = now > 0 ? now - turn : now + turn; // the range ends at one turn
    Scene scene = session.document.scene;
    for (const auto& [time, value] : {std::pair{0.0F, now}, std::pair{seconds, then}}) {
        if (const Result<std::size_t> added = putKey(scene, path, time, formatNumber(value)); !added)
            return say(session, fmt::format("A key frame can't be added: {}.", describe(added.error())));
    }
    session.document.scene = std::move(scene);
    recordAlone(session, "Turn the view", path);
    session.window.playback.time = 0;
    session.window.playback.playing = true;
}

void removeKey(Session& session, std::size_t key) {
    Scene& scene = session.document.scene;
    if (key >= scene.timeline.keys.size())
        return;
    const Scene before = scene;
    const std::string path = scene.timeline.keys[key].path;
    scene.timeline.keys.erase(scene.timeline.keys.begin() + static_cast<std::ptrdiff_t>(key));
    stayAsNow(session, path, before);
    recordAlone(session, "Remove key frame", path);
}

void removeKeys(Session& session, std::string_view path) {
    Scene& scene = session.document.scene;
    const Scene before = scene;
    const std::string kept(path); // it may be part of one of the keys
    dropKeys(scene.timeline, kept);
    stayAsNow(session, kept, before);
    recordAlone(session, "Remove key frames", kept);
}

bool moveKey(Session& session, std::size_t key, float time) {
    std::vector<KeyFrame>& keys = session.document.scene.timeline.keys;
    const float wanted = std::clamp(time, 0.0F, maxKeyTime);
    if (key >= keys.size() || keys[key].time == wanted)
        return false;
    keys[key].time = wanted;
    recordScene(session, "Move key frame", keys[key].path);
    return true;
}

void setEasing(Session& session, std::size_t key, Easing easing) {
    std::vector<KeyFrame>& keys = session.document.scene.timeline.keys;
    if (key >= keys.size() || keys[key].easing == easing)
        return;
    keys[key].easing = easing;
    recordAlone(session, "Easing", keys[key].path);
}

} // namespace texplorer::ui
