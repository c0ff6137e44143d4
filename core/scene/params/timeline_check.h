#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/params/params.h"

namespace texplorer {

// Checks key frames against their scene.

/// Checks a key: its parameter exists and accepts the value, and is not part of the timeline. `where` is
/// "/path" or "/value".
[[nodiscard]] Result<void> checkKey(const Scene& scene, const KeyFrame& key);

/// The same while a key is edited, where path and value are entered one after the other: a new path must
/// exist, regardless of the value. `where` is empty.
[[nodiscard]] Result<void> checkEditedKey(const Scene& scene, const KeyFrame& key, const ParamRow& edited);

/// Checks all keys, and that the values at every time fit each other: units have their texture, passes their
/// models, lists their vertices. `where` is a JSON pointer relative to the timeline: "/3/path", or empty.
[[nodiscard]] Result<void> checkTimeline(const Scene& scene);

/// Returns the keys that can be written to a file: those that are valid. If valid keys do not fit each other,
/// the keys of interdependent parameters are left out.
[[nodiscard]] Timeline fittingTimeline(const Scene& scene);

} // namespace texplorer
