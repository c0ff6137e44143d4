#pragma once

#include "app/ui/widgets/param_widgets.h"

#include <optional>
#include <string_view>

namespace texplorer::ui {

/// The target of a path, to edit a parameter by its path.
struct ParamPlace {
    Owner owner; ///< without initial values
    const ParamRow* row = nullptr;
    /// Of a list: "models[0].texCoords0[5]", "models[0].mesh.positions[5]".
    std::optional<std::size_t> vertex{};
    std::size_t vertices = 1; ///< from that one on, which an edit changes together
};

/// Nothing if there is no such parameter.
[[nodiscard]] std::optional<ParamPlace> placeOf(const Scene& scene, std::string_view path);

/// One of the numbers of an Int, a Float, a vector, a matrix or a vertex's coordinates. `component` is used
/// for those with several numbers.
[[nodiscard]] float numberAt(const ParamPlace& place, int component);

/// Submits another number as its control does: clamped to the row's range.
void assignNumber(const Session& session, const ParamPlace& place, int component, float number);

/// How many vertices from the place's on have its normal, for which there is one call; 1 for other lists.
[[nodiscard]] std::size_t sharedFrom(const ParamPlace& place);

/// The range and step of a drag.
[[nodiscard]] Range rangeOf(const ParamPlace& place);

} // namespace texplorer::ui
