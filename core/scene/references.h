#pragma once

// What names elements of lists by their index: units their texture, passes their models, key frames their
// parameters.

#include "texplorer/scene/scene.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

namespace texplorer {

/// The new index of each element of a list; nullopt: it was removed.
using Renumbering = std::function<std::optional<std::size_t>(std::size_t index)>;
[[nodiscard]] Renumbering afterInsert(std::size_t index);
[[nodiscard]] Renumbering afterRemove(std::size_t index);
/// The elements between both indices have moved by one.
[[nodiscard]] Renumbering afterMove(std::size_t from, std::size_t to);

/// Updates all indices of elements of a list, "models" or "passes[0].units[1].matrix", after it has changed,
/// so that they name the same elements, also in the values of key frames. Key frames of a removed element are
/// removed; a unit uses the texture before a removed one, and is disabled if there is none; a pass that named
/// only the removed model is disabled, because without names it would draw all.
void renumber(Scene& scene, std::string_view list, const Renumbering& number);

} // namespace texplorer
