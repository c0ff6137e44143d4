#include "app/view/sent_sentence.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace texplorer::view {

using nlohmann::json;

json sentJson(const Sentence& sentence) {
    if (sentence.isNumber())
        return {{"number", sentence.english()},
                {"whole", sentence.number() ? json(*sentence.number()) : json()}};
    if (sentence.key().empty())
        return sentence.isName() ? json{{"name", sentence.english()}} : json(sentence.english());
    json arguments = json::array();
    for (const Sentence& each : sentence.arguments())
        arguments.push_back(sentJson(each));
    return {{"key", sentence.key()}, {"arguments", std::move(arguments)}};
}

Sentence sentSentence(const json& sent, const KnownKey& known) {
    if (sent.is_string())
        return sent.get<std::string>();
    if (sent.contains("number"))
        return Sentence::ofNumber(
            sent["number"].get<std::string>(),
            sent.at("whole").is_null() ? std::nullopt : std::optional(sent["whole"].get<std::uint64_t>()));
    if (sent.contains("name"))
        return ProperName{sent["name"].get_ref<const std::string&>()};
    std::vector<Sentence> arguments;
    for (const json& each : sent.at("arguments"))
        arguments.push_back(sentSentence(each, known));
    const auto& key = sent.at("key").get_ref<const std::string&>();
    if (const std::optional<std::string_view> literal = known(key))
        return Sentence::ofParts(*literal, std::move(arguments));
    return Sentence::ofParts(key, std::move(arguments)).english();
}

} // namespace texplorer::view
