#pragma once

#include "core/scene/params/params.h"

#include <nlohmann/json.hpp>

namespace texplorer {

/// Keeps the order of its members, and floats as short as they are.
using OrderedJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                         std::uint64_t, float>;

/// The value as scene files hold it; a list of what each vertex has is empty.
[[nodiscard]] OrderedJson jsonValue(const ParamRow& row, const Value& value);

} // namespace texplorer
