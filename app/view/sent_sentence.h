#pragma once

// Sentences that pass from one process, or one instance of a program, to another.

#include "texplorer/base/sentence.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::view {

/// A text, {"name": a text}, {"number": its text, "whole": a whole number or null}, or {"key", "arguments"}.
[[nodiscard]] nlohmann::json sentJson(const Sentence& sentence);

/// The key of a sentence, which has to exist as long as the program; none: the sentence becomes a text.
using KnownKey = std::function<std::optional<std::string_view>(const std::string& key)>;

/// The same sentence. Throws an exception of nlohmann-json for anything else.
[[nodiscard]] Sentence sentSentence(const nlohmann::json& sent, const KnownKey& known);

} // namespace texplorer::view
