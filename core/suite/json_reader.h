#pragma once

// Reading JSON strictly: what nobody asked for is refused, with its place and the nearest key that there is.

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::suite {

using Json = nlohmann::json; ///< an ordered object would look through all its keys for each one that it reads
using OrderedJson = nlohmann::ordered_json; ///< for writing: few keys, in the order of their lines

/// A whole text. Errors: TooLarge above `maxBytes` and for brackets in brackets; Malformed with the line,
/// also for a key that an object has twice.
[[nodiscard]] Result<Json> parseJson(std::string_view text, std::size_t maxBytes);

/// JSON that is only written: strings that are no UTF-8 have U+FFFD in their place.
template<class AnyJson>
[[nodiscard]] std::string dumpJson(const AnyJson& json, int indent = -1) {
    return json.dump(indent, ' ', false, AnyJson::error_handler_t::replace);
}

/// The first problem of a text.
using Problem = std::optional<Error>;

/// The members of an object are taken one by one; what nobody took is unknown. After a problem nothing is
/// said.
class JsonObject {
public:
    JsonObject(const Json& json, std::string where, Problem& problem);
    ~JsonObject();
    JsonObject(const JsonObject&) = delete;
    JsonObject& operator=(const JsonObject&) = delete;

    /// nullptr: it isn't there.
    const Json* find(const char* key);
    const Json* need(const char* key);

    // Each leaves `target` alone where the member isn't there.
    void text(const char* key, std::string& target, std::size_t maxBytes);
    void flag(const char* key, bool& target);
    void number(const char* key, double& target, double lowest, double highest);
    void whole(const char* key, std::size_t& target, std::size_t lowest, std::size_t highest);
    void whole(const char* key, int& target, int lowest, int highest);

    /// Calls `take(json, place)` for each element of a list, or for what stands alone. Whether it is there.
    template<class Take>
    bool oneOrMore(const char* key, std::size_t most, const Take& take) {
        const Json* value = find(key);
        if (value && value->is_array())
            eachOf(key, *value, 1, most, take);
        else if (value)
            take(*value, placeOf(key));
        return value != nullptr;
    }
    template<class Take>
    void list(const char* key, std::size_t fewest, std::size_t most, const Take& take) {
        const Json* value = fewest > 0 ? need(key) : find(key);
        if (value && !value->is_array())
            refuse(key, "a list");
        else if (value)
            eachOf(key, *value, fewest, most, take);
    }

    void refuse(const std::string& key, const std::string& expected);
    void say(ErrorCode code, const std::string& key, std::string message);
    [[nodiscard]] std::string placeOf(std::string_view key) const;
    [[nodiscard]] Problem& problem() { return problem_; }

private:
    template<class Take>
    void eachOf(const char* key, const Json& values, std::size_t fewest, std::size_t most, const Take& take) {
        if (values.size() < fewest || values.size() > most)
            return refuseCount(key, fewest, most, values.size());
        for (std::size_t i = 0; i < values.size() && !problem_; ++i)
            take(values[i], placeOf(key) + "/" + std::to_string(i));
    }
    void refuseCount(const char* key, std::size_t fewest, std::size_t most, std::size_t found);

    const Json& json_;
    std::string where_;
    Problem& problem_;
    std::vector<std::string_view> taken_;
};

/// "text", "12", "a list", for a sentence that says what was found.
[[nodiscard]] std::string foundText(const Json& json);

} // namespace texplorer::suite
