#include "texplorer/scene/params/json_problem.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace texplorer {
namespace {

/// What may come next. "First": directly after a bracket, so that the other bracket may come as well.
enum class Next { Value, FirstValue, Key, FirstKey, Colon, CommaInObject, CommaInArray, End };

constexpr std::array expected{
    N_("a value"),           N_("a value"),    N_("a key in quotes"), N_("a key in quotes"),
    N_("':' after the key"), N_("',' or '}'"), N_("',' or ']'"),      N_("the end of the file")};

constexpr std::string_view digits = "0123456789";

/// The word or sign at a place, printable: "'NaN'"; empty at the end.
std::string wordAt(std::string_view text, std::size_t at) {
    const auto isLetter = [](char each) {
        return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z');
    };
    const std::string_view rest = text.substr(std::min(at, text.size()));
    const auto letters = static_cast<std::size_t>(std::ranges::find_if_not(rest, isLetter) - rest.begin());
    const std::string_view word =
        rest.substr(0, letters > 0 ? letters : std::max<std::size_t>(firstCharacter(rest).bytes, 1));
    return word.empty() ? std::string() : fmt::format("'{}'", shortened(word));
}

/// Of a text in quotes, the number of its bytes; or what is wrong with it.
struct Lexeme {
    std::size_t bytes = 0;
    std::optional<Sentence> problem;
};

/// `position`: the library has stopped there if it is within the text.
Lexeme textLexeme(std::string_view text, std::size_t at, std::size_t position) {
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != '"')
        end += text[end] == '\\' ? 2U : 1U;
    if (end < text.size() && end < position && isUtf8(text.substr(at, end - at)))
        return {end + 1 - at, {}};
    if (position > text.size())
        return {0, Sentence("the file ends in the middle of a text; expected a quote")};
    position = std::max(position, at + 2);
    const auto stopped = static_cast<unsigned char>(text[position - 1]);
    if (!isUtf8(text.substr(at, position - 1 - at))) // a character is not complete
        return {0, Sentence("expected UTF-8, found the byte {0:02X}",
                            static_cast<unsigned char>(text[position - 2]))};
    if (stopped >= 0x80)
        return {0, Sentence("expected UTF-8, found the byte {0:02X}", stopped)};
    if (stopped == '\n' || stopped == '\r')
        return {0, Sentence("the line ends in the middle of a text; expected a quote")};
    if (stopped < 0x20)
        return {0, Sentence("expected \\u{0:04x} for a control character in a text", stopped)};
    return {0, Sentence("expected an escape such as \\\" or \\u00e9, found {0}",
                        ProperName{wordAt(text, position - 1)})};
}

Lexeme numberLexeme(std::string_view text, std::size_t at) {
    std::size_t end = at;
    const auto skipped = [&](std::string_view any) {
        const bool isThere = end < text.size() && any.find(text[end]) != std::string_view::npos;
        end += isThere ? 1 : 0;
        return isThere;
    };
    const auto someDigits = [&] {
        const std::size_t begin = end;
        end = std::min(text.find_first_not_of(digits, end), text.size());
        return end > begin;
    };
    skipped("-");
    bool isWhole = skipped("0") || someDigits();
    if (isWhole && skipped("."))
        isWhole = someDigits();
    if (isWhole && skipped("eE")) {
        skipped("+-");
        isWhole = someDigits();
    }
    if (isWhole)
        return {end - at, {}};
    return {0, end == text.size() ? Sentence("the file ends in the middle of a number; expected a digit")
                                  : Sentence("expected a digit, found {0}", ProperName{wordAt(text, end)})};
}

/// One of the words of JSON; empty: another one.
std::string_view literalAt(std::string_view text, std::size_t at) {
    for (const std::string_view word : {"true", "false", "null"}) {
        if (text.substr(at).starts_with(word))
            return word;
    }
    return {};
}

/// Reads a text as far as it is JSON.
class FaultReader {
public:
    FaultReader(std::string_view text, std::size_t position)
        : text_(text)
        , position_(position)
        , at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

    Sentence problem() {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
            if (at_ == text_.size())
                return ended();
            if (const std::optional<Sentence> problem = step())
                return *problem;
        }
    }

private:
    Sentence ended() const {
        const char* what = expected[static_cast<std::size_t>(next_)];
        if (brackets_.empty())
            return next_ == Next::End ? Sentence("expected JSON")
                                      : Sentence("the file ends; expected {0}", what);
        return Sentence("the file ends in the middle of {0}; expected {1}",
                        brackets_.back() == '{' ? N_("an object") : N_("an array"), what);
    }

    Sentence refused(const Sentence& found) const {
        return Sentence("expected {0}, found {1}", expected[static_cast<std::size_t>(next_)], found);
    }

    /// Reads a token.
    std::optional<Sentence> step() {
        const char sign = text_[at_];
        const bool isValue = next_ == Next::Value || next_ == Next::FirstValue;
        const bool isKey = next_ == Next::Key || next_ == Next::FirstKey;
        if (sign == '"') {
            const Lexeme token = textLexeme(text_, at_, position_);
            if (token.problem || (!isValue && !isKey))
                return token.problem ? *token.problem : refused(N_("a text in quotes"));
            if (position_ == at_ + token.bytes) // else the library reads on
                return Sentence("expected a surrogate pair, such as \\ud83d\\ude00, found one half");
            return pass(token.bytes, isKey ? Next::Colon : afterValue());
        }
        if (sign == '-' || digits.find(sign) != std::string_view::npos) {
            const Lexeme token = numberLexeme(text_, at_);
            if (token.problem || !isValue)
                return token.problem ? *token.problem : refused(N_("a number"));
            return pass(token.bytes, afterValue());
        }
        if (isValue && (sign == '{' || sign == '[')) {
            brackets_ += sign;
            return pass(1, sign == '{' ? Next::FirstKey : Next::FirstValue);
        }
        if ((sign == '}' && (next_ == Next::FirstKey || next_ == Next::CommaInObject)) ||
            (sign == ']' && (next_ == Next::FirstValue || next_ == Next::CommaInArray))) {
            brackets_.pop_back();
            return pass(1, afterValue());
        }
        if (sign == ':' && next_ == Next::Colon)
            return pass(1, Next::Value);
        if (sign == ',' && (next_ == Next::CommaInObject || next_ == Next::CommaInArray))
            return pass(1, next_ == Next::CommaInObject ? Next::Key : Next::Value);
        if (const std::string_view literal = literalAt(text_, at_); isValue && !literal.empty())
            return pass(literal.size(), afterValue());
        return refused(ProperName{wordAt(text_, at_)});
    }

    std::optional<Sentence> pass(std::size_t bytes, Next next) {
        at_ += bytes;
        next_ = next;
        return std::nullopt;
    }

    Next afterValue() const {
        return brackets_.empty()         ? Next::End
               : brackets_.back() == '{' ? Next::CommaInObject
                                         : Next::CommaInArray;
    }

    std::string_view text_;
    std::size_t position_;
    std::size_t at_;
    Next next_ = Next::Value;
    std::string brackets_; ///< that are open
};

} // namespace

Sentence jsonProblem(std::string_view text, int exception, std::size_t position) {
    constexpr int numberOverflow = 406;
    if (exception == numberOverflow)
        return N_("expected a smaller number");
    return FaultReader(text, position).problem();
}

std::string lineAndColumn(std::string_view text, std::size_t position) {
    const std::string_view read = text.substr(0, position);
    const std::size_t line = read.rfind('\n') + 1; // 0 where there is none
    return fmt::format("line {}, column {}", 1 + std::ranges::count(read, '\n'), position - line);
}

} // namespace texplorer
