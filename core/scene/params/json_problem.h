#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// What the JSON library says of a mistake in the grammar ("syntax error while parsing object key -
/// unexpected end of input; expected string literal"), in words for somebody who wrote the file: "the file
/// ends in the middle of an object; expected a key in quotes". What isn't understood stays as it is.
[[nodiscard]] std::string readableProblem(std::string_view said);

} // namespace texplorer
