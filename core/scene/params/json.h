#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <string>
#include <string_view>

namespace texplorer {

inline constexpr int sceneFormatVersion = 1;

/// The extension of scene files, which desktops recognise. Any ".json" can be read.
inline constexpr std::string_view sceneExtension = ".texplorer.json";

/// The longest text that parseScene accepts.
inline constexpr std::size_t maxSceneBytes = std::size_t{16} << 20;

/// Parses a scene file; thread-safe. Missing members have their value in defaultScene(); a list that is
/// present replaces the default list, and its elements begin with GL's initial values. Errors, with the JSON
/// pointer in Error::where: unknown and repeated keys, wrong types, numbers out of range, unknown names, too
/// many elements, a later version, coordinates that do not fit their mesh, an enabled unit without a texture,
/// key frames of parameters that do not exist. If the text is not JSON, `where` is a line and a column.
[[nodiscard]] Result<Scene> parseScene(std::string_view json);

/// Writes the whole scene with the name of its schema and every parameter (the timeline only if it has keys);
/// parseScene(writeScene(s)) == s for every scene that parseScene accepts. Left out: lists of texture
/// coordinates that are empty or do not fit their mesh, and key frames that do not fit the scene.
[[nodiscard]] std::string writeScene(const Scene& scene);

/// The same scene in its shortest form: only parameters that differ from the values of a file without them.
[[nodiscard]] std::string writeShortScene(const Scene& scene);

} // namespace texplorer
