#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <optional>

namespace texplorer {

/// Returns the scene at a time, in seconds: every parameter with keys has its value at that time
/// (texplorer/scene/timeline.h), and the timeline is empty. At a key, it is exactly the key's value. Keys
/// that do not fit the scene are ignored, so this works for every scene. Rates (Model::spin,
/// MatrixStep::rate) stay: functions that use them still need the time.
[[nodiscard]] Scene sceneAt(const Scene& scene, double time);

/// The same without a copy if nothing has keys. Refers to the scene, which must outlive it.
class StandingScene {
public:
    StandingScene(const Scene& scene, double time)
        : scene_(scene) {
        if (!scene.timeline.keys.empty())
            made_ = sceneAt(scene, time);
    }
    StandingScene(Scene&&, double) = delete;

    [[nodiscard]] const Scene& operator*() const { return made_ ? *made_ : scene_; }
    [[nodiscard]] const Scene* operator->() const { return &**this; }

private:
    const Scene& scene_;
    std::optional<Scene> made_;
};

} // namespace texplorer
