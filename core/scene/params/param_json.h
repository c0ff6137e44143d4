#pragma once

#include "texplorer/scene/params/params.h"

#include <nlohmann/json.hpp>

namespace texplorer {

/// Keeps the order of its members, and writes floats with the fewest digits.
using OrderedJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                         std::uint64_t, float>;

/// The value as in scene files; lists of per-vertex values are written empty.
[[nodiscard]] OrderedJson jsonValue(const ParamRow& row, const Value& value);

} // namespace texplorer
