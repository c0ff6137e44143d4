#pragma once

// The JSON of lessons, suites and runs.

#include "texplorer/scene/params/json_object.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string_view>

namespace texplorer {

/// Parses a whole text. Errors: TooLarge above `maxBytes` and for deep nesting; Malformed with the line, or
/// for repeated keys with their JSON pointer.
[[nodiscard]] Result<nlohmann::json> parseStrictJson(std::string_view text, std::size_t maxBytes);

/// Reads the version of a format, a key that is needed. Errors: Unsupported for a version after `newest`;
/// Malformed.
void readVersion(JsonObject& object, const char* key, int newest);

} // namespace texplorer
