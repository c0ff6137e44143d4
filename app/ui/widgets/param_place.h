#pragma once

#include "app/ui/widgets/param_widgets.h"

#include <optional>
#include <string_view>

namespace texplorer::ui {

/// Where a path leads, for what edits a parameter by its path.
struct ParamPlace {
    Owner owner; ///< without initial values
    const ParamRow* row = nullptr;
    std::optional<std::size_t> vertex{}; ///< of a list: "models[0].texCoords0[5]"
};

/// Nothing where there is no such parameter.
[[nodiscard]] std::optional<ParamPlace> placeOf(Scene& scene, std::string_view path);

/// One of the numbers of an Int, a Float, a vector, a matrix or a vertex's coordinates. `component` counts
/// for those that have several.
[[nodiscard]] float numberAt(const ParamPlace& place, int component);

/// Changes it as its control does: kept within the row's range, recorded. True where it changed.
bool assignNumber(Session& session, const ParamPlace& place, int component, float number);

/// What a drag does to it.
[[nodiscard]] Range rangeOf(const ParamPlace& place);

} // namespace texplorer::ui
