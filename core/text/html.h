#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// Escapes a text for HTML, between tags or in an attribute in double quotes. Pass untrusted text through
/// printable first.
[[nodiscard]] inline std::string escapedHtml(std::string_view text) {
    std::string html;
    for (const char each : text) {
        switch (each) {
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '&':
            html += "&amp;";
            break;
        case '"':
            html += "&quot;";
            break;
        default:
            html += each;
        }
    }
    return html;
}

} // namespace texplorer
