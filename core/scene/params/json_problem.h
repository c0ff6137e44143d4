#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// Rewrites the JSON library's message about a syntax error ("syntax error while parsing object key -
/// unexpected end of input; expected string literal") for authors of files: "the file ends in the middle of
/// an object; expected a key in quotes". Unknown messages are returned unchanged.
[[nodiscard]] std::string readableProblem(std::string_view said);

/// The same of the whole text of one of the library's exceptions: "[json.exception.parse_error.101] parse
/// error at line 1, column 2: syntax error …; last read: '…'", which may be long, and not even UTF-8.
[[nodiscard]] std::string mistakeIn(int exception, std::string_view said);

} // namespace texplorer
