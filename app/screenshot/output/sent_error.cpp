#include "app/screenshot/output/sent_error.h"

#include "app/screenshot/output/message_ids.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::screenshot {
namespace {

using nlohmann::json;

/// A text, {"name": a text}, {"number": its text, "whole": a whole number or null}, or {"key", "arguments"}.
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

Sentence sentSentence(const json& sent) {
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
        arguments.push_back(sentSentence(each));
    const auto& key = sent.at("key").get_ref<const std::string&>();
    if (const std::optional<std::string_view> known = knownMessage(key))
        return Sentence::ofParts(*known, std::move(arguments));
    return Sentence::ofParts(key, std::move(arguments)).english();
}

/// One of an enumeration's values, the first of which is 0.
template<class Enum>
Enum sentValue(const json& sent, Enum last) {
    const auto number = sent.get<unsigned>();
    if (number > static_cast<unsigned>(last))
        throw json::out_of_range::create(401, "no such value", &sent);
    return static_cast<Enum>(number);
}

} // namespace

json sentJson(const Error& error) {
    json steps = json::array();
    for (const Location::Step& each : error.where.steps())
        steps.push_back({static_cast<int>(each.kind), each.text, each.line, each.column});
    return {{"code", static_cast<int>(error.code)},
            {"message", sentJson(error.message)},
            {"where", std::move(steps)}};
}

Error sentError(const json& sent) {
    Error error{sentValue(sent.at("code"), ErrorCode::Cancelled), sentSentence(sent.at("message")), {}};
    for (const json& each : sent.at("where"))
        error.where = error.where /
                      Location(Location::Step{sentValue(each.at(0), Location::Kind::Name),
                                              each.at(1).get<std::string>(), each.at(2).get<std::size_t>(),
                                              each.at(3).get<std::size_t>()});
    return error;
}

} // namespace texplorer::screenshot
