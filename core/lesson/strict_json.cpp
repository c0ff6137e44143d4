#include "texplorer/lesson/strict_json.h"

#include "texplorer/scene/params/json_problem.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/json_encoding.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texplorer {
namespace {

constexpr std::size_t maxJsonDepth = 24;

/// A list or an object that has begun and not ended.
struct OpenBracket {
    bool isList;
    std::size_t elements = 0;          ///< of a list, so far
    std::set<std::string> keys{};      ///< of an object, so far
    const std::string* last = nullptr; ///< of the keys
};

/// What is wrong with a text: it is no JSON, or it is nested too deeply, or has a key twice.
class StrictChecker : public nlohmann::json_sax<nlohmann::json> {
public:
    explicit StrictChecker(std::string_view text)
        : text_(text) {}

    bool null() override { return count(); }
    bool boolean(bool /*value*/) override { return count(); }
    bool number_integer(number_integer_t /*value*/) override { return count(); }
    bool number_unsigned(number_unsigned_t /*value*/) override { return count(); }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return count(); }
    bool string(string_t& /*value*/) override { return count(); }
    bool binary(binary_t& /*value*/) override { return count(); }
    bool start_object(std::size_t /*elements*/) override { return open(false); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t /*elements*/) override { return open(true); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        OpenBracket& object = brackets_.back();
        const auto [at, isNew] = object.keys.insert(key);
        object.last = &*at;
        if (isNew)
            return true;
        problem_ = Error{ErrorCode::Malformed,
                         Sentence("expected each key once, found {0} twice", ProperName{inQuotes(key)}),
                         atPointer(pointer())};
        return false;
    }

    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const nlohmann::json::exception& error) override {
        JsonProblem problem = jsonProblem(text_, error.id, position);
        problem_ = Error{ErrorCode::Malformed, std::move(problem.message), problem.where};
        return false;
    }

    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

private:
    bool open(bool isList) {
        if (brackets_.size() < maxJsonDepth) {
            brackets_.push_back({.isList = isList});
            return true;
        }
        problem_ =
            Error{ErrorCode::TooLarge, Sentence("expected at most {0} levels of brackets", maxJsonDepth), {}};
        return false;
    }

    bool close() {
        brackets_.pop_back();
        return count();
    }

    /// A value has ended.
    bool count() {
        if (!brackets_.empty())
            ++brackets_.back().elements;
        return true;
    }

    [[nodiscard]] std::string pointer() const {
        std::string text;
        for (const OpenBracket& each : brackets_)
            text += "/" + (each.isList ? std::to_string(each.elements) : pointerStep(shortened(*each.last)));
        return text;
    }

    std::string_view text_;
    std::vector<OpenBracket> brackets_;
    std::optional<Error> problem_;
};

} // namespace

Result<nlohmann::json> parseStrictJson(std::string_view text, std::size_t maxBytes) {
    if (text.size() > maxBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} bytes, found {1}", maxBytes, text.size()));
    if (const Result<void> whole = checkEncoding(text); !whole)
        return fail(whole.error());
    StrictChecker checker(text);
    if (!nlohmann::json::sax_parse(text, &checker))
        return fail(*checker.problem());
    return nlohmann::json::parse(text, nullptr, false); // which throws nothing: it was read once
}

void readVersion(JsonObject& object, const char* key, int newest) {
    const nlohmann::json* version = object.need(key);
    if (!version)
        return;
    const bool isWhole = version->is_number_integer();
    if (!isWhole || *version < 1 || *version > newest)
        object.say(isWhole && *version > newest ? ErrorCode::Unsupported : ErrorCode::Malformed, key,
                   Sentence("expected version {0}, found {1}", newest, foundText(*version)));
}

} // namespace texplorer
