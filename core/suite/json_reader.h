#pragma once

#include "texplorer/lesson/strict_json.h"

namespace texplorer::suite {

using Json = nlohmann::json;                ///< an ordered object would search all its keys for each member
using OrderedJson = nlohmann::ordered_json; ///< for writing: few keys, in the order of their lines

/// Writes JSON; invalid UTF-8 in strings becomes U+FFFD.
template<class AnyJson>
[[nodiscard]] std::string dumpJson(const AnyJson& json, int indent = -1) {
    return json.dump(indent, ' ', false, AnyJson::error_handler_t::replace);
}

/// The first problem of a text.
using Problem = std::optional<Error>;

} // namespace texplorer::suite
