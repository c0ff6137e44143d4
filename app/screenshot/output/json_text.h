#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace texplorer::screenshot {

/// A document as it is printed. What is no UTF-8, as a file's name may be, becomes U+FFFD.
[[nodiscard]] inline std::string documentText(const nlohmann::ordered_json& document) {
    return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace texplorer::screenshot
