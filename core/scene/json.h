#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>

namespace texplorer {

inline constexpr int sceneFormatVersion = 1;

/// Reads a scene file. What a file leaves out keeps its value in defaultScene(); a list that is present
/// replaces the default's list, and its elements begin with GL's initial values. Refused, with the JSON
/// pointer in Error::where: unknown keys, wrong types, numbers out of range, unknown names, too many
/// elements, a version from the future.
[[nodiscard]] Result<Scene> parseScene(std::string_view json);

/// The whole scene, every parameter written out; parseScene(writeScene(s)) == s for every valid scene.
[[nodiscard]] std::string writeScene(const Scene& scene);

} // namespace texplorer
