#pragma once

#include "texplorer/base/result.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>

namespace texplorer::screenshot {

// What --json asks for is one document on standard output, of every command and of a call that fails, too:
//   {"texshot": its version, "schema": of these documents, "command": its name, "results": […], "problems":
//   […]}
// "results" has what the command says of each file, picture or row; "problems" the errors of standard error.

/// The command whose document it is, "" if the call names none. Call it before other threads run.
void noteCommand(std::string_view command);

/// Adds a problem. Any thread may.
void noteError(const Error& error);

/// {"id", "message", "arguments"}: the ID is null for a text from elsewhere, as the system's; an argument is
/// a number, a text or such an object.
[[nodiscard]] nlohmann::ordered_json messageJson(const Sentence& message);

/// firstIdOf, or null.
[[nodiscard]] nlohmann::ordered_json firstIdJson(const Sentence& sentence);

[[nodiscard]] nlohmann::ordered_json messagesJson(std::span<const Sentence> messages);

/// messageJson with "where", the steps of the location, and "code", the name of an ErrorCode.
[[nodiscard]] nlohmann::ordered_json problemJson(const Error& problem);

/// The document with these results, an array. A text that is not UTF-8, as a file's name may be, has U+FFFD;
/// a number that was a float has the fewest digits that give the same float.
[[nodiscard]] std::string documentText(nlohmann::ordered_json results);

/// The document without results of a call that has failed; empty if it has not.
[[nodiscard]] std::string errorText();

} // namespace texplorer::screenshot
