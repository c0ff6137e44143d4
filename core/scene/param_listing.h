#pragma once

#include <string>

namespace texplorer {

/// Every parameter with its default, what it accepts and its help, as text for a terminal. It walks the
/// tables, not a scene: the elements of a list are written once, as "textures[].minFilter". Ends with a line
/// feed.
[[nodiscard]] std::string listParams();

/// The same for programs: one object with "version", "parameters" (path, kind, default, range or choices,
/// label, help, glCall) and "lists" (path, minCount, maxCount).
[[nodiscard]] std::string listParamsJson();

} // namespace texplorer
