#pragma once

#include "texplorer/scene/params/json_object.h"

namespace texplorer::suite {

using Json = nlohmann::json;                ///< an ordered object would search all its keys for each member
using OrderedJson = nlohmann::ordered_json; ///< for writing: few keys, in the order of their lines

/// Parses a whole text. Errors: TooLarge above `maxBytes` and for deep nesting; Malformed with the line, also
/// for repeated keys.
[[nodiscard]] Result<Json> parseJson(std::string_view text, std::size_t maxBytes);

/// Writes JSON; invalid UTF-8 in strings becomes U+FFFD.
template<class AnyJson>
[[nodiscard]] std::string dumpJson(const AnyJson& json, int indent = -1) {
    return json.dump(indent, ' ', false, AnyJson::error_handler_t::replace);
}

/// The first problem of a text.
using Problem = std::optional<Error>;

} // namespace texplorer::suite
