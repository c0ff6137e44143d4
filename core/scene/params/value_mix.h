#pragma once

#include "texplorer/scene/params/params.h"

namespace texplorer {

/// Whether values of a parameter can be interpolated: numbers, vectors, colours, matrices and per-vertex
/// lists can. Names, texts, booleans, and numbers that are indices (a unit's texture, the models of a pass)
/// cannot.
[[nodiscard]] bool canMix(const ParamRow& row);

/// Interpolates two values at `share` from 0 to 1, each component separately, whole numbers rounded. The
/// result is exactly `from` at 0 and `to` at 1, and never outside. Values that cannot be interpolated, such
/// as lists of different lengths, are `from` below 1. Both must hold the row's type.
[[nodiscard]] Value mixed(const ParamRow& row, const Value& from, const Value& to, double share);

} // namespace texplorer
