#pragma once

#include "app/ui/model/selection.h"
#include "core/base/result.h"
#include "core/scene/params/scene_diff.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace texplorer::ui {

struct Session;

/// A: what a document was when the user kept it, to compare what is now with. Undo leaves it alone.
struct Kept {
    std::shared_ptr<const Scene> scene; ///< nullptr: nothing is kept
    /// The same, seen by the present camera: what the view draws of it. nullptr: it draws nothing of it.
    std::shared_ptr<const Scene> seen;
    /// The scene beside which the view shows A: any edit of it but of the camera leads back to what is now.
    std::optional<Scene> flippedAt;
    Selection selection{}; ///< of the time when it was kept
};

/// The scene as it is now becomes A.
void keepAsA(Session& session);
/// The view shows A in the place of what is now, or that again. Nothing happens where nothing is kept.
void flipKept(Session& session);
/// The view shows both across one picture, or one again. Nothing happens where nothing is kept.
void splitKept(Session& session);
void forgetKept(Session& session);

[[nodiscard]] bool isKeptShown(const Session& session);
[[nodiscard]] bool isKeptBeside(const Session& session);

/// Brings up to date what follows the scene: to be called by `settle`.
void followKept(Session& session);

/// What differs from A but for the place of the camera, from A to now; empty where nothing is kept.
[[nodiscard]] std::vector<SceneChange> changesSinceKept(const Session& session);

/// A's value becomes that of the scene, a step of undo. Models or passes that come back are selected as they
/// were in A. The error says why it doesn't fit.
[[nodiscard]] Result<void> takeFromKept(Session& session, const SceneChange& change);
/// The same of everything but the place of the camera.
void takeAllFromKept(Session& session);

} // namespace texplorer::ui
