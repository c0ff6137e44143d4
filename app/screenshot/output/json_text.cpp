#include "app/screenshot/output/json_text.h"

#include "app/screenshot/output/message_ids.h"
#include "texplorer/base/error_name.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schemaId = "file:///usr/share/texplorer/output.schema.json"; // as of scenes

struct Document {
    std::mutex mutex;
    std::string command; ///< guarded by it, as is
    Json problems = Json::array();
};

Document& ours() {
    static Document document;
    return document;
}

Json argumentJson(const Sentence& argument) {
    if (argument.number())
        return argument.english().starts_with('-') ? Json(static_cast<std::int64_t>(*argument.number()))
                                                   : Json(*argument.number());
    if (argument.isNumber()) {
        Json number = Json::parse(argument.english(), nullptr, false);
        return number.is_number() ? number : Json(argument.english()); // none of JSON, as infinity
    }
    return argument.key().empty() ? Json(argument.english()) : messageJson(argument);
}

/// An object for each step, from the outside.
Json locationJson(const Location& location) {
    constexpr std::array<const char*, 6> keys{"file", "line", "option", "parameter", "pointer", "name"};
    Json steps = Json::array();
    for (const Location::Step& each : location.steps()) {
        const char* key = keys[static_cast<std::size_t>(each.kind)];
        Json& step = steps.emplace_back();
        step[key] = each.kind == Location::Kind::Line ? Json(each.line) : Json(each.text);
        if (each.column > 0)
            step["column"] = each.column;
    }
    return steps;
}

void shortenFloats(Json& json) {
    if (json.is_number_float()) {
        const auto number = json.get<double>();
        if (const auto single = static_cast<float>(number);
            static_cast<double>(single) == number && number != 0 && std::isfinite(number))
            json = Json::parse(fmt::format("{}", single)).get<double>();
    } else if (json.is_structured()) {
        for (Json& each : json)
            shortenFloats(each);
    }
}

} // namespace

void noteCommand(std::string_view command) {
    const std::scoped_lock lock(ours().mutex);
    ours().command = command;
}

void noteError(const Error& error) {
    Json problem = problemJson(error);
    const std::scoped_lock lock(ours().mutex);
    ours().problems.push_back(std::move(problem));
}

Json messageJson(const Sentence& message) {
    const std::optional<int> id = idOf(message);
    Json arguments = Json::array();
    for (const Sentence& each : message.arguments())
        arguments.push_back(argumentJson(each));
    return {
        {"id", id ? Json(*id) : Json()}, {"message", message.english()}, {"arguments", std::move(arguments)}};
}

Json firstIdJson(const Sentence& sentence) {
    const std::optional<int> id = firstIdOf(sentence);
    return id ? Json(*id) : Json();
}

Json messagesJson(std::span<const Sentence> messages) {
    Json list = Json::array();
    for (const Sentence& each : messages)
        list.push_back(messageJson(each));
    return list;
}

Json problemJson(const Error& problem) {
    Json json = messageJson(problem.message);
    json["where"] = locationJson(problem.where);
    json["code"] = nameOf(problem.code);
    return json;
}

std::string documentText(Json results) {
    shortenFloats(results);
    const std::scoped_lock lock(ours().mutex);
    const Json document{{"texshot", TEXPLORER_VERSION},
                        {"schema", schemaId},
                        {"command", ours().command},
                        {"results", std::move(results)},
                        {"problems", ours().problems}};
    return document.dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n"; // NaN and infinity become null
}

std::string errorText() {
    const bool isError = [] {
        const std::scoped_lock lock(ours().mutex);
        return !ours().problems.empty();
    }();
    return isError ? documentText(Json::array()) : std::string();
}

} // namespace texplorer::screenshot
