#include "texplorer/scene/params/json_object.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/json_encoding.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace texplorer {

Sentence foundText(const nlohmann::json& json) {
    if (json.is_string())
        return ProperName{inQuotes(json.get_ref<const std::string&>())};
    if (json.is_array())
        return N_("a list");
    if (json.is_object())
        return N_("an object");
    return ProperName{json.dump()};
}

JsonObject::JsonObject(const nlohmann::json& json, std::string where, std::optional<Error>& problem)
    : json_(json)
    , where_(std::move(where))
    , problem_(problem) {
    if (!json.is_object())
        say(ErrorCode::Malformed, "", Sentence("expected {0}, found {1}", N_("an object"), foundText(json)));
}

JsonObject::~JsonObject() {
    if (!json_.is_object() || problem_)
        return;
    for (const auto& [key, value] : json_.items()) {
        if (std::ranges::find(taken_, key) == taken_.end())
            say(ErrorCode::Malformed, shortened(key), Sentence("unknown key; {0}", suggestName(key, taken_)));
    }
}

const nlohmann::json* JsonObject::find(const char* key) {
    if (std::ranges::find(taken_, key) == taken_.end())
        taken_.emplace_back(key);
    const auto found = json_.is_object() ? json_.find(key) : json_.end();
    return found == json_.end() ? nullptr : &*found;
}

const nlohmann::json* JsonObject::need(const char* key) {
    const nlohmann::json* found = find(key);
    if (!found)
        say(ErrorCode::Malformed, "", Sentence("expected the key \"{0}\"", key));
    return found;
}

void JsonObject::text(const char* key, std::string& target, std::size_t maxBytes) {
    const nlohmann::json* value = find(key);
    if (!value)
        return;
    if (!value->is_string())
        return expect(key, N_("a text"));
    target = value->get<std::string>();
    if (target.size() > maxBytes)
        say(ErrorCode::TooLarge, key,
            Sentence("expected at most {0} bytes, found {1}", maxBytes, target.size()));
}

void JsonObject::flag(const char* key, bool& target) {
    const nlohmann::json* value = find(key);
    if (value && value->is_boolean())
        target = value->get<bool>();
    else if (value)
        expect(key, N_("true or false"));
}

void JsonObject::number(const char* key, double& target, double min, double max) {
    const nlohmann::json* value = find(key);
    if (!value)
        return;
    const double found = value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (found >= min && found <= max)
        target = found;
    else
        expect(key, Sentence("a number from {0} to {1}", min, max));
}

void JsonObject::whole(const char* key, std::size_t& target, std::size_t min, std::size_t max) {
    const nlohmann::json* value = find(key);
    if (!value)
        return;
    if (value->is_number_unsigned() && *value >= min && *value <= max)
        target = value->get<std::size_t>();
    else
        expect(key, Sentence("a whole number from {0} to {1}", min, max));
}

void JsonObject::whole(const char* key, int& target, int min, int max) {
    const nlohmann::json* value = find(key);
    if (!value)
        return;
    if (value->is_number_integer() && *value >= min && *value <= max)
        target = value->get<int>();
    else
        expect(key, Sentence("a whole number from {0} to {1}", min, max));
}

void JsonObject::expect(const std::string& key, const Sentence& expected) {
    const auto found = json_.is_object() ? json_.find(key) : json_.end();
    say(ErrorCode::Malformed, key,
        found == json_.end() ? Sentence("expected {0}", expected)
                             : Sentence("expected {0}, found {1}", expected, foundText(*found)));
}

void JsonObject::refuseCount(const char* key, std::size_t min, std::size_t max, std::size_t found) {
    say(found > max ? ErrorCode::TooLarge : ErrorCode::Malformed, key,
        Sentence("expected a list of {0} to {1}, found {2}", min, max, found));
}

void JsonObject::say(ErrorCode code, const std::string& key, Sentence message) {
    if (!problem_)
        problem_ = Error{code, std::move(message), atPointer(key.empty() ? where_ : placeOf(key))};
}

std::string JsonObject::placeOf(std::string_view key) const {
    return fmt::format("{}/{}", where_, pointerStep(key));
}

} // namespace texplorer
