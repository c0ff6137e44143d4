#pragma once

#include <string>
#include <string_view>

namespace texplorer::emit {

/// The functions of JavaScript that a text calls, and those that they call: for a page of WebGL.
[[nodiscard]] std::string jsFunctionsFor(std::string_view text);

} // namespace texplorer::emit
