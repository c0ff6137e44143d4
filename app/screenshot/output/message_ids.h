#pragma once

#include "texplorer/base/sentence.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::screenshot {

/// A file of assets, compiled in.
struct AnswerFile {
    std::string_view name;
    std::string_view text;
};

/// The IDs of messages, translations/messages.ids, and the schema of what --json prints,
/// schemas/output.schema.json.
[[nodiscard]] const std::vector<AnswerFile>& answerFiles();

/// The number of a message, which no change of its words changes; none if its text comes from elsewhere, as
/// those of the system and of drivers.
[[nodiscard]] std::optional<int> idOf(const Sentence& message);

/// That of what a sentence says first: of "{0}; {1}" the first, of "where: message" the message.
[[nodiscard]] std::optional<int> firstIdOf(const Sentence& sentence);

/// The key of a message that has an ID, for the time of the program; none: no message has this key.
[[nodiscard]] std::optional<std::string_view> knownMessage(const std::string& key);

} // namespace texplorer::screenshot
