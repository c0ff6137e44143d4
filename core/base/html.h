#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// A text as it stands in HTML, between tags or as an attribute in double quotes. Make what comes from
/// outside printable before.
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
