#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <optional>

namespace texplorer {

/// The scene as it stands at a time, in seconds: every parameter that has keys is what they say then
/// (core/scene/timeline.h), and the timeline is empty. At a key it is the key's value to the last bit. A key
/// that doesn't fit the scene any more does nothing, so that this is an answer for every scene. What turns by
/// itself (Model::spin, MatrixStep::rate) is as it was: it wants the time as before.
[[nodiscard]] Scene sceneAt(const Scene& scene, double time);

/// The same without a copy where nothing has keys. Holds a reference to the scene, which must outlive it.
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
