#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// A parameter that two scenes have with different values, or a list that has different lengths.
struct SceneChange {
    std::string path;  ///< "textures[0].wrapS"; of a list: "textures"
    std::string label; ///< "Wrap s"
    std::string from; ///< "GL_REPEAT"; of a list's length "2 elements", of a long list the first that differs
    std::string to;
    bool isLength = false; ///< of elements that only one of them has, this is all that is said

    bool operator==(const SceneChange&) const = default;
};

/// What leads from one scene to the other, in the order of the tables; empty: they are the same.
[[nodiscard]] std::vector<SceneChange> changesBetween(const Scene& from, const Scene& to);

/// Gives a scene the value that another one has at the path of a change between both; a list gets its length,
/// with the elements that are new. Errors: NotFound where they don't both have that path; OutOfRange where
/// members that fit each other wouldn't any more (a unit without its texture). It is then what it was.
[[nodiscard]] Result<void> takeOver(Scene& scene, const Scene& from, std::string_view path);

} // namespace texplorer
