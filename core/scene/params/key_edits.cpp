#include "texplorer/scene/params/key_edits.h"

#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/timeline_check.h"

#include <algorithm>

namespace texplorer {
namespace {

/// That of the key before; what is new goes at the same speed.
Easing easingAt(const Timeline& timeline, std::string_view path, float time) {
    for (const Track& track : tracksOf(timeline)) {
        if (track.path == path)
            return momentOf(track, double{time}).from->easing;
    }
    return KeyFrame{}.easing;
}

} // namespace

bool hasKeys(const Timeline& timeline, std::string_view path) {
    return std::ranges::any_of(timeline.keys, [path](const KeyFrame& key) { return key.path == path; });
}

std::optional<std::size_t> keyAt(const Timeline& timeline, std::string_view path, float time) {
    for (std::size_t i = timeline.keys.size(); i-- > 0;) {
        if (timeline.keys[i].time == time && timeline.keys[i].path == path)
            return i;
    }
    return std::nullopt;
}

Result<std::size_t> putKey(Scene& scene, std::string_view path, float time, std::string_view value) {
    Timeline& timeline = scene.timeline;
    const std::optional<std::size_t> there = keyAt(timeline, path, time);
    if (!(time >= 0 && time <= maxKeyTime))
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a time from 0 to {0} s, found {1} s", maxKeyTime, time));
    if (!there && timeline.keys.size() >= maxKeyFrames)
        return fail(ErrorCode::TooLarge, Sentence("expected at most {0} key frames", maxKeyFrames));
    const Easing easing = there ? timeline.keys[*there].easing : easingAt(timeline, path, time);
    KeyFrame key{time, std::string(path), std::string(value), easing};
    if (const Result<void> fits = checkKey(scene, key); !fits)
        return fail(fits.error().code, fits.error().message);
    if (there) {
        timeline.keys[*there] = std::move(key);
        return *there;
    }
    timeline.keys.push_back(std::move(key));
    return timeline.keys.size() - 1;
}

void dropKeys(Timeline& timeline, std::string_view path) {
    std::erase_if(timeline.keys, [path](const KeyFrame& key) { return key.path == path; });
}

Result<bool> keyEdits(Scene& edited, const Scene& before, float time) {
    if (before.timeline.keys.empty() || edited.timeline != before.timeline)
        return false;
    bool changed = false;
    for (const Track& track : tracksOf(before.timeline)) {
        const Result<std::string> now = getParam(edited, track.path);
        const Result<std::string> was = getParam(before, track.path);
        if (!now || !was || *now == *was)
            continue;
        if (const Result<std::size_t> put = putKey(edited, track.path, time, *now); !put)
            return fail(put.error());
        changed = true;
    }
    return changed;
}

void putUnkeyed(Scene& scene, const Scene& from) {
    for (const Track& track : tracksOf(from.timeline)) {
        const Result<std::string> value = getParam(from, track.path);
        // What isn't there any more has nothing to be put back.
        if (value && hasKeys(scene.timeline, track.path))
            static_cast<void>(putBetween(scene, track.path, *value, *value, 0));
    }
}

} // namespace texplorer
