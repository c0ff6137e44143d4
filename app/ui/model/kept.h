#pragma once

#include "app/ui/state/selection.h"
#include "texplorer/scene/params/scene_diff.h"
#include "texplorer/scene/scene.h"

#include <vector>

namespace texplorer::ui {

struct Session;

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
