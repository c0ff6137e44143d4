#include "app/web/sent_sentences.h"

#include "app/view/sent_sentence.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <set>

namespace texplorer::web {

using nlohmann::json;

namespace {

/// The program's own keys: their number has a limit.
std::optional<std::string_view> keptKey(const std::string& key) {
    static std::set<std::string> keys;
    return *keys.insert(key).first;
}

} // namespace

std::string sentSentences(const std::vector<Sentence>& sentences) {
    json all = json::array();
    for (const Sentence& each : sentences)
        all.push_back(view::sentJson(each));
    return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<Sentence> receivedSentences(std::string_view sent) {
    std::vector<Sentence> sentences;
    for (const json& each : json::parse(sent))
        sentences.push_back(view::sentSentence(each, keptKey));
    return sentences;
}

} // namespace texplorer::web
