#pragma once

// Strict reading of JSON: unknown members are errors, with their place and the nearest known key.

#include "texplorer/base/result.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// Reads the members of an object one by one; the destructor reports the members that were not read as
/// unknown. Only the first problem is reported.
class JsonObject {
public:
    JsonObject(const nlohmann::json& json, std::string where, std::optional<Error>& problem);
    ~JsonObject();
    JsonObject(const JsonObject&) = delete;
    JsonObject& operator=(const JsonObject&) = delete;

    /// Returns nullptr if the member is missing.
    const nlohmann::json* find(const char* key);
    const nlohmann::json* need(const char* key);
    [[nodiscard]] bool has(const char* key) const { return json_.is_object() && json_.contains(key); }

    // These leave `target` unchanged if the member is missing.
    void text(const char* key, std::string& target, std::size_t maxBytes);
    void flag(const char* key, bool& target);
    void number(const char* key, double& target, double min, double max);
    void whole(const char* key, std::size_t& target, std::size_t min, std::size_t max);
    void whole(const char* key, int& target, int min, int max);

    /// Calls `take(json, place)` for each element of a list, or for a single value. Returns whether the
    /// member exists.
    template<class Take>
    bool oneOrMore(const char* key, std::size_t max, const Take& take) {
        const nlohmann::json* value = find(key);
        if (value && value->is_array())
            eachOf(key, *value, 1, max, take);
        else if (value)
            take(*value, placeOf(key));
        return value != nullptr;
    }
    template<class Take>
    void list(const char* key, std::size_t min, std::size_t max, const Take& take) {
        const nlohmann::json* value = min > 0 ? need(key) : find(key);
        if (value && !value->is_array())
            expect(key, N_("a list"));
        else if (value)
            eachOf(key, *value, min, max, take);
    }

    void expect(const std::string& key, const Sentence& expected);
    void say(ErrorCode code, const std::string& key, Sentence message);
    [[nodiscard]] std::string placeOf(std::string_view key) const;
    [[nodiscard]] std::optional<Error>& problem() { return problem_; }

private:
    template<class Take>
    void eachOf(const char* key, const nlohmann::json& values, std::size_t min, std::size_t max,
                const Take& take) {
        if (values.size() < min || values.size() > max)
            return refuseCount(key, min, max, values.size());
        for (std::size_t i = 0; i < values.size() && !problem_; ++i)
            take(values[i], placeOf(key) + "/" + std::to_string(i));
    }
    void refuseCount(const char* key, std::size_t min, std::size_t max, std::size_t found);

    const nlohmann::json& json_;
    std::string where_;
    std::optional<Error>& problem_;
    std::vector<std::string_view> taken_;
};

/// "text", "12", "a list", for a message about what was found.
[[nodiscard]] Sentence foundText(const nlohmann::json& json);

} // namespace texplorer
