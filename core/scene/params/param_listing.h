#pragma once

#include "core/scene/params/params.h"

#include <functional>
#include <string>

namespace texplorer {

/// Which parameters are listed; `path` is "textures[].minFilter". None: all.
using ParamFilter = std::function<bool(const std::string& path, const ParamRow& row)>;

/// Calls `visit` for every parameter of a scene that has one element in each list, a new one; its path is
/// "textures[].minFilter".
void forEachNewParam(
    const std::function<void(const std::string& path, const ParamRow& row, const Value& initial)>& visit);

/// Every parameter with the value that a scene has which doesn't say it, what it accepts and its help, as
/// text for a terminal. The elements of a list are written once, as "textures[].minFilter", with the values
/// of a new one. Ends with a line feed; empty where the filter leaves nothing.
[[nodiscard]] std::string listParams(const ParamFilter& filter = {});

/// The same for programs: one object with "version", "parameters" (path, kind, default, range or choices,
/// label, help, glCall) and "lists" (path, minCount, maxCount).
/// Lists are those that the parameters lie in.
[[nodiscard]] std::string listParamsJson(const ParamFilter& filter = {});

} // namespace texplorer
