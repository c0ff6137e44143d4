#include "core/suite/json_reader.h"

#include "core/scene/params/json_problem.h"
#include "core/scene/params/param_text.h"
#include "core/text/json_end.h"
#include "core/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace texplorer::suite {
namespace {

constexpr std::size_t maxJsonDepth = 24;

/// Of "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error …; last read: '…'",
/// which may be long.
std::string mistakeOf(const Json::exception& error) {
    constexpr int numberOverflow = 406;
    if (error.id == numberOverflow)
        return "expected a smaller number";
    std::string_view said = error.what();
    said = said.substr(0, said.find("; last read"));
    const std::size_t syntax = said.find("syntax error");
    return printable(readableProblem(syntax == std::string_view::npos ? said : said.substr(syntax)));
}

/// What is wrong with a text: it is no JSON, or it is nested too deeply, or has a key twice.
class Checker : public nlohmann::json_sax<Json> {
public:
    explicit Checker(std::string_view text)
        : text_(text) {}

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool start_object(std::size_t /*elements*/) override { return open(); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t /*elements*/) override { return open(); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        if (keys_.back().insert(key).second)
            return true;
        problem_ = Error{
            ErrorCode::Malformed, fmt::format("expected each key once, found {} again", inQuotes(key)), {}};
        return false;
    }

    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const Json::exception& error) override {
        const std::string_view read = text_.substr(0, std::min(text_.size(), position));
        problem_ = Error{ErrorCode::Malformed, mistakeOf(error),
                         fmt::format("line {}", 1 + std::ranges::count(read, '\n'))};
        return false;
    }

    [[nodiscard]] const Problem& problem() const { return problem_; }

private:
    bool open() {
        if (keys_.size() < maxJsonDepth) {
            keys_.emplace_back();
            return true;
        }
        problem_ = Error{
            ErrorCode::TooLarge, fmt::format("expected at most {} levels of brackets", maxJsonDepth), {}};
        return false;
    }

    bool close() {
        keys_.pop_back();
        return true;
    }

    std::string_view text_;
    std::vector<std::set<std::string>> keys_; ///< of each bracket that is open
    Problem problem_;
};

} // namespace

Result<Json> parseJson(std::string_view text, std::size_t maxBytes) {
    if (text.size() > maxBytes)
        return fail(ErrorCode::TooLarge,
                    fmt::format("expected at most {} bytes, found {}", maxBytes, text.size()));
    if (const Result<void> whole = checkNoNul(text); !whole)
        return fail(whole.error());
    Checker checker(text);
    if (!Json::sax_parse(text, &checker))
        return fail(*checker.problem());
    return Json::parse(text, nullptr, false); // which throws nothing: it was read once
}

std::string foundText(const Json& json) {
    if (json.is_string())
        return inQuotes(json.get_ref<const std::string&>());
    if (json.is_array())
        return "a list";
    if (json.is_object())
        return "an object";
    return json.dump();
}

JsonObject::JsonObject(const Json& json, std::string where, Problem& problem)
    : json_(json)
    , where_(std::move(where))
    , problem_(problem) {
    if (!json.is_object())
        say(ErrorCode::Malformed, "", fmt::format("expected an object, found {}", foundText(json)));
}

JsonObject::~JsonObject() {
    if (!json_.is_object() || problem_)
        return;
    for (const auto& [key, value] : json_.items()) {
        if (std::ranges::find(taken_, key) == taken_.end())
            say(ErrorCode::Malformed, shortened(key),
                fmt::format("unknown key; {}", suggestName(key, taken_)));
    }
}

const Json* JsonObject::find(const char* key) {
    if (std::ranges::find(taken_, key) == taken_.end())
        taken_.emplace_back(key);
    const auto found = json_.is_object() ? json_.find(key) : json_.end();
    return found == json_.end() ? nullptr : &*found;
}

const Json* JsonObject::need(const char* key) {
    const Json* found = find(key);
    if (!found)
        say(ErrorCode::Malformed, "", fmt::format("expected the key \"{}\"", key));
    return found;
}

void JsonObject::text(const char* key, std::string& target, std::size_t maxBytes) {
    const Json* value = find(key);
    if (!value)
        return;
    if (!value->is_string())
        return refuse(key, "a text");
    target = value->get<std::string>();
    if (target.size() > maxBytes)
        say(ErrorCode::TooLarge, key,
            fmt::format("expected at most {} bytes, found {}", maxBytes, target.size()));
}

void JsonObject::flag(const char* key, bool& target) {
    const Json* value = find(key);
    if (value && value->is_boolean())
        target = value->get<bool>();
    else if (value)
        refuse(key, "true or false");
}

void JsonObject::number(const char* key, double& target, double min, double max) {
    const Json* value = find(key);
    if (!value)
        return;
    const double found = value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (found >= min && found <= max)
        target = found;
    else
        refuse(key, fmt::format("a number from {} to {}", min, max));
}

void JsonObject::whole(const char* key, std::size_t& target, std::size_t min, std::size_t max) {
    const Json* value = find(key);
    if (!value)
        return;
    if (value->is_number_unsigned() && *value >= min && *value <= max)
        target = value->get<std::size_t>();
    else
        refuse(key, fmt::format("a whole number from {} to {}", min, max));
}

void JsonObject::whole(const char* key, int& target, int min, int max) {
    const Json* value = find(key);
    if (!value)
        return;
    if (value->is_number_integer() && *value >= min && *value <= max)
        target = value->get<int>();
    else
        refuse(key, fmt::format("a whole number from {} to {}", min, max));
}

void JsonObject::refuse(const std::string& key, const std::string& expected) {
    const auto found = json_.is_object() ? json_.find(key) : json_.end();
    say(ErrorCode::Malformed, key,
        found == json_.end() ? fmt::format("expected {}", expected)
                             : fmt::format("expected {}, found {}", expected, foundText(*found)));
}

void JsonObject::refuseCount(const char* key, std::size_t min, std::size_t max, std::size_t found) {
    say(found > max ? ErrorCode::TooLarge : ErrorCode::Malformed, key,
        fmt::format("expected a list of {} to {}, found {}", min, max, found));
}

void JsonObject::say(ErrorCode code, const std::string& key, std::string message) {
    if (!problem_)
        problem_ = Error{code, std::move(message), key.empty() ? where_ : placeOf(key)};
}

std::string JsonObject::placeOf(std::string_view key) const {
    return fmt::format("{}/{}", where_, key);
}

} // namespace texplorer::suite
