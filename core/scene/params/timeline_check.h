#pragma once

#include "core/base/result.h"
#include "core/scene/params/params.h"

namespace texplorer {

// Whether key frames fit their scene.

/// One key: its parameter exists and takes the value; the timeline's own parameters can't move. `where` is
/// "/path" or "/value".
[[nodiscard]] Result<void> checkKey(const Scene& scene, const KeyFrame& key);

/// The same while a key is edited, of which path and value come one after the other: a new path needs to
/// exist, whatever the value is. `where` is empty.
[[nodiscard]] Result<void> checkEditedKey(const Scene& scene, const KeyFrame& key, const ParamRow& edited);

/// All of them, and that what they set at any time fits together: units have their texture, passes their
/// models, lists their vertices. `where` is a JSON pointer below the timeline's: "/3/path", or empty.
[[nodiscard]] Result<void> checkTimeline(const Scene& scene);

/// The keys that a file may have: those that fit. Where what fits alone doesn't fit together, the keys of
/// parameters that depend on each other are left out.
[[nodiscard]] Timeline fittingTimeline(const Scene& scene);

} // namespace texplorer
