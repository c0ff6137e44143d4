#pragma once

#include "core/scene/params/params.h"

namespace texplorer {

/// Whether there is anything between two values of a parameter: numbers, vectors, colours, matrices and what
/// each vertex has. Names, texts, what is on or off, and numbers that count others (a unit's texture, the
/// models of a pass) have nothing between them.
[[nodiscard]] bool canMix(const ParamRow& row);

/// What lies `share` (0 to 1) of the way from one to the other, each component on its own, whole numbers
/// rounded: `from` at 0 and `to` at 1, to the last bit, and never beyond either. What can't be mixed, as
/// lists of different lengths, is `from` below 1. Both hold the row's alternative.
[[nodiscard]] Value mixed(const ParamRow& row, const Value& from, const Value& to, double share);

} // namespace texplorer
