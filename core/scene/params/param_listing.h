#pragma once

#include "texplorer/scene/params/params.h"

#include <functional>
#include <string>

namespace texplorer {

/// Selects the parameters to list; `path` is "textures[].minFilter". Empty: all.
using ParamFilter = std::function<bool(const std::string& path, const ParamRow& row)>;

/// Calls `visit` for every parameter of a scene with one new element in each list; the paths are like
/// "textures[].minFilter".
void forEachNewParam(
    const std::function<void(const std::string& path, const ParamRow& row, const Value& initial)>& visit);

/// Lists every parameter with its default in scene files, its accepted values and its help, as text for a
/// terminal. The elements of a list are listed once, as "textures[].minFilter", with the values of a new one.
/// Ends with a line feed; empty if the filter selects nothing.
[[nodiscard]] std::string listParams(const ParamFilter& filter = {});

/// The same as JSON: an object with "version", "parameters" (path, kind, default, range or choices, label,
/// help, glCall) and "lists" (path, minCount, maxCount). Lists are those that contain the selected
/// parameters.
[[nodiscard]] std::string listParamsJson(const ParamFilter& filter = {});

} // namespace texplorer
