#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// A parameter with different values in two scenes, or a list with different lengths.
struct SceneChange {
    std::string path;  ///< "textures[0].wrapS"; for a list: "textures"
    std::string label; ///< "Wrap s"
    /// "GL_REPEAT"; for a list's length "2 elements", for a long list the first element that differs.
    Sentence from;
    Sentence to;
    bool isLength = false; ///< elements that only one scene has are not listed further

    bool operator==(const SceneChange&) const = default;
};

/// Returns the changes from one scene to the other, in the order of the tables; empty if they are equal.
[[nodiscard]] std::vector<SceneChange> changesBetween(const Scene& from, const Scene& to);

/// The same without texts: only the paths.
[[nodiscard]] std::vector<std::string> changedPaths(const Scene& from, const Scene& to);

/// Copies the values at the paths of changes from another scene; for a list, its length and its additional
/// elements. Errors, without changes: NotFound if not both have one of the paths; OutOfRange if members would
/// not fit each other (a unit without its texture).
[[nodiscard]] Result<void> takeOver(Scene& scene, const Scene& from, std::span<const std::string> paths);

} // namespace texplorer
