#pragma once

#include "app/ui/model/selection.h"
#include "core/scene/params/scene_diff.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace texplorer::ui {

struct Session;

/// A: the state of a document that the user kept, for comparisons with the current state. Undo does not
/// change it.
struct Kept {
    std::shared_ptr<const Scene> scene; ///< nullptr: no state is kept
    /// The same scene with the current camera, for the view. nullptr: the view does not draw it.
    std::shared_ptr<const Scene> seen;
    /// The current scene while the view shows A: any edit except of the camera switches back to the current
    /// scene.
    std::optional<Scene> flippedAt;
    Selection selection{}; ///< at the time when it was kept
};

/// Keeps the current scene as A.
void keepAsA(Session& session);
/// Switches the view between A and the current scene. Does nothing if no state is kept.
void flipKept(Session& session);
/// Switches the split view of both on or off. Does nothing if no state is kept.
void splitKept(Session& session);
void forgetKept(Session& session);

[[nodiscard]] bool isKeptShown(const Session& session);
[[nodiscard]] bool isKeptBeside(const Session& session);

/// Updates everything that depends on the scene. Called by `settle`.
void followKept(Session& session);

/// The differences from A to the current scene, except the camera; empty if no state is kept.
[[nodiscard]] std::vector<SceneChange> changesSinceKept(const Session& session);

/// Submits a step that sets the scene to A's value. Restored models or passes are selected as in A.
void takeFromKept(const Session& session, const SceneChange& change);
/// The same for all differences, except the camera.
void takeAllFromKept(const Session& session);

} // namespace texplorer::ui
