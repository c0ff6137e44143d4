#pragma once

// Edits of key frames (texplorer/scene/timeline.h).

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace texplorer {

[[nodiscard]] bool hasKeys(const Timeline& timeline, std::string_view path);

/// The index of a parameter's key at a time; of several, the last, which is used from then on.
[[nodiscard]] std::optional<std::size_t> keyAt(const Timeline& timeline, std::string_view path, float time);

/// Sets a parameter's value at a time: changes its key there, or adds one with the easing of the previous
/// key. Returns the key's index. Errors: the parameter does not exist, does not accept the value or cannot
/// move; there are maxKeyFrames; the time is invalid.
[[nodiscard]] Result<std::size_t> putKey(Scene& scene, std::string_view path, float time,
                                         std::string_view value);

/// Removes the keys of a parameter.
void dropKeys(Timeline& timeline, std::string_view path);

/// Converts edits to keys: each parameter with keys whose value differs between `edited` and `before` gets a
/// key with the new value at `time`. Does nothing if the timelines differ. Returns whether a key was added or
/// changed. Errors: those of putKey.
[[nodiscard]] Result<bool> keyEdits(Scene& edited, const Scene& before, float time);

/// Sets the parameters that have keys to their values in `from`.
void putUnkeyed(Scene& scene, const Scene& from);

} // namespace texplorer
