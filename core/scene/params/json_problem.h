#pragma once

#include "texplorer/base/location.h"
#include "texplorer/base/sentence.h"

#include <cstddef>
#include <string_view>

namespace texplorer {

/// What is wrong with a text that the JSON library refuses.
struct JsonProblem {
    Sentence message; ///< "expected a key in quotes, found '}'"
    Location where;
};

/// Reads a text once again, up to what is wrong. `exception` is the library's ID of its error, `position` the
/// number of bytes that it has read: for a number that is too large, which is no fault of the text.
[[nodiscard]] JsonProblem jsonProblem(std::string_view text, int exception, std::size_t position);

} // namespace texplorer
