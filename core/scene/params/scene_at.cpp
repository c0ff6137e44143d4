#include "texplorer/scene/params/scene_at.h"

#include "texplorer/scene/params/params.h"

namespace texplorer {

Scene sceneAt(const Scene& scene, double time) {
    Scene standing = scene;
    standing.timeline.keys.clear();
    for (const Track& track : tracksOf(scene.timeline)) {
        const auto [from, to, share] = momentOf(track, time);
        const std::string& next = to ? to->value : from->value;
        // A key of something that isn't there, or of the timeline itself, is refused and does nothing.
        static_cast<void>(putBetween(standing, track.path, from->value, next, share));
    }
    return standing;
}

} // namespace texplorer
