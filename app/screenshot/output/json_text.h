#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace texplorer::screenshot {

/// What --json asks for is one document on standard output, also of a call that fails: then it has "error",
/// the first sentence that standard error got. Any thread may note one.
void noteError(const std::string& sentence);

/// A document as it is printed, with "error" before the rest where the call has failed. What is no UTF-8, as
/// a file's name may be, becomes U+FFFD.
[[nodiscard]] std::string documentText(const nlohmann::ordered_json& document);

/// The document of a call that has nothing else to say; empty: it hasn't failed.
[[nodiscard]] std::string errorText();

} // namespace texplorer::screenshot
