#pragma once

#include <string>

namespace texplorer {

/// Every parameter with the value that a scene has which doesn't say it, what it accepts and its help, as
/// text for a terminal. The elements of a list are written once, as "textures[].minFilter", with the values
/// of a new one. Ends with a line feed.
[[nodiscard]] std::string listParams();

/// The same for programs: one object with "version", "parameters" (path, kind, default, range or choices,
/// label, help, glCall) and "lists" (path, minCount, maxCount).
[[nodiscard]] std::string listParamsJson();

} // namespace texplorer
