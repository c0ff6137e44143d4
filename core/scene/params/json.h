#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>

namespace texplorer {

inline constexpr int sceneFormatVersion = 1;

/// What the name of a scene file ends in, by which a desktop knows it. Any ".json" is read.
inline constexpr std::string_view sceneExtension = ".texplorer.json";

/// The longest file that parseScene looks at.
inline constexpr std::size_t maxSceneBytes = std::size_t{16} << 20;

/// Reads a scene file; any number of threads may at once. What a file leaves out keeps its value in
/// defaultScene(); a list that is present replaces the default's list, and its elements begin with GL's
/// initial values. Refused, with the JSON pointer in Error::where: unknown and repeated keys, wrong types,
/// numbers out of range, unknown names, too many elements, a version from the future, coordinates that don't
/// fit their mesh, an enabled unit without a texture, key frames of what isn't there. Where the text isn't
/// JSON, `where` is a line and a column.
[[nodiscard]] Result<Scene> parseScene(std::string_view json);

/// The whole scene with the name of its schema, every parameter written out (a timeline where it has keys);
/// parseScene(writeScene(s)) == s for every scene that parseScene would accept. Left out: lists of texture
/// coordinates that are empty or don't fit their mesh, and key frames that don't fit the scene.
[[nodiscard]] std::string writeScene(const Scene& scene);

/// The same scene with the fewest words: only what differs from what a file stands for that doesn't say it.
[[nodiscard]] std::string writeShortScene(const Scene& scene);

} // namespace texplorer
