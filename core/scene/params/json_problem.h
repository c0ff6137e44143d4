#pragma once

#include "texplorer/base/sentence.h"

#include <cstddef>
#include <string_view>

namespace texplorer {

/// Rewrites the JSON library's message about a syntax error ("syntax error while parsing object key -
/// unexpected end of input; expected string literal") for authors of files: "the file ends in the middle of
/// an object; expected a key in quotes". Unknown messages are returned unchanged. `found`: wordAt, for what
/// is no JSON.
[[nodiscard]] Sentence readableProblem(std::string_view said, std::string_view found);

/// The same of the whole text of one of the library's exceptions: "[json.exception.parse_error.101] parse
/// error at line 1, column 2: syntax error …; last read: '…'", which may be long, and not even UTF-8.
/// `found`: wordAt.
[[nodiscard]] Sentence mistakeIn(int exception, std::string_view said, std::string_view found);

/// What stands where the library has stopped, after `position` bytes of a text: "'NaN'", "','", printable;
/// empty: the text has ended.
[[nodiscard]] std::string wordAt(std::string_view text, std::size_t position);

} // namespace texplorer
