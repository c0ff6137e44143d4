#include "app/screenshot/output/message_ids.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <unordered_map>

namespace texplorer::screenshot {
namespace {

/// A line's text without its quotes: \" \\ \n and \t as in gettext's files.
std::string unquoted(std::string_view text) {
    std::string plain;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        const bool isEscape = text[i] == '\\';
        i += isEscape ? 1 : 0;
        plain += isEscape && text[i] == 'n' ? '\n' : isEscape && text[i] == 't' ? '\t' : text[i];
    }
    return plain;
}

std::unordered_map<std::string, int> readIds() {
    std::unordered_map<std::string, int> ids;
    std::string_view rest = answerFiles().front().text;
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        int id = 0;
        const char* end = std::from_chars(line.data(), line.data() + line.size(), id).ptr;
        ids.emplace(unquoted(line.substr(static_cast<std::size_t>(end - line.data()) + 1)), id);
    }
    return ids;
}

} // namespace

std::optional<int> idOf(const Sentence& message) {
    static const std::unordered_map<std::string, int> ids = readIds();
    const auto found = ids.find(message.key().empty() ? message.english() : std::string(message.key()));
    return found == ids.end() ? std::nullopt : std::optional(found->second);
}

} // namespace texplorer::screenshot
