#pragma once

#include "texplorer/base/sentence.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer::web {

/// Sentences as JSON, as they pass between a page and its workers.
[[nodiscard]] std::string sentSentences(const std::vector<Sentence>& sentences);

/// The same sentences. Throws an exception of nlohmann-json for anything else.
[[nodiscard]] std::vector<Sentence> receivedSentences(std::string_view sent);

} // namespace texplorer::web
