#pragma once

// What an editor does with key frames (core/scene/timeline.h).

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace texplorer {

[[nodiscard]] bool hasKeys(const Timeline& timeline, std::string_view path);

/// The number of the key that a parameter has at a time: of several the last one, which counts from there on.
[[nodiscard]] std::optional<std::size_t> keyAt(const Timeline& timeline, std::string_view path, float time);

/// A parameter is `value` at a time: its key there, or a new one, which goes on as the one before it does.
/// The key's number. Errors: there is no such parameter, it doesn't take the value, it can't move, there are
/// maxKeyFrames, the time is none of a key.
[[nodiscard]] Result<std::size_t> putKey(Scene& scene, std::string_view path, float time,
                                         std::string_view value);

/// The parameter stands still from here on.
void dropKeys(Timeline& timeline, std::string_view path);

/// A parameter that has keys is nothing but them: where `edited` has another value of one than `before`, it
/// gets a key with it at `time`. Nothing where the timelines are different. True where there is a key now
/// that wasn't there, or was another one. Errors: those of putKey.
[[nodiscard]] Result<bool> keyEdits(Scene& edited, const Scene& before, float time);

/// The parameters that have keys become what they are in `from`.
void putUnkeyed(Scene& scene, const Scene& from);

} // namespace texplorer
