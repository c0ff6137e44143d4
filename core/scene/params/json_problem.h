#pragma once

#include "texplorer/base/sentence.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace texplorer {

/// Says what is wrong with a text that the JSON library refuses, which was expected and which was found:
/// "expected a key in quotes, found '}'". `exception` is the library's ID of the error, `position` the number
/// of bytes that it has read; the text is read once again up to there.
[[nodiscard]] Sentence jsonProblem(std::string_view text, int exception, std::size_t position);

/// The place of the byte before `position`: "line 2, column 5", the column in bytes.
[[nodiscard]] std::string lineAndColumn(std::string_view text, std::size_t position);

} // namespace texplorer
