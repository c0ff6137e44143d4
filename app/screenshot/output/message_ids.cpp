#include "app/screenshot/output/message_ids.h"

#include "texplorer/base/further.h"
#include "texplorer/base/result.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <string>
#include <unordered_map>

namespace texplorer::screenshot {
namespace {

using Ids = std::unordered_map<std::string, int>;

Ids readIds() {
    Ids ids;
    std::string_view rest = answerFiles().front().text;
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        int id = 0;
        const char* end = std::from_chars(line.data(), line.data() + line.size(), id).ptr;
        // What gettext escapes in a text, JSON does as well.
        ids.emplace(nlohmann::json::parse(end, line.data() + line.size()).get<std::string>(), id);
    }
    return ids;
}

const Ids& allIds() {
    static const Ids ids = readIds();
    return ids;
}

} // namespace

std::optional<int> idOf(const Sentence& message) {
    const auto found = allIds().find(message.key().empty() ? message.english() : std::string(message.key()));
    return found == allIds().end() ? std::nullopt : std::optional(found->second);
}

std::optional<int> firstIdOf(const Sentence& sentence) {
    if (sentence.key() == furtherKey.text)
        return firstIdOf(sentence.arguments().front());
    return idOf(sentence.key() == describedKey.text ? sentence.arguments().back() : sentence);
}

std::optional<std::string_view> knownMessage(const std::string& key) {
    const auto found = allIds().find(key);
    return found == allIds().end() ? std::nullopt : std::optional<std::string_view>(found->first);
}

} // namespace texplorer::screenshot
