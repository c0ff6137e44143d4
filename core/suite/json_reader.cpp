#include "texplorer/suite/json_reader.h"

#include "texplorer/scene/params/json_problem.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/json_end.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <vector>

namespace texplorer::suite {
namespace {

constexpr std::size_t maxJsonDepth = 24;

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
        problem_ = Error{ErrorCode::Malformed, mistakeIn(error.id, error.what()),
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

} // namespace texplorer::suite
