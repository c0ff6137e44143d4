#include "texplorer/scene/params/json_problem.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/json_encoding.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

namespace texplorer {
namespace {

/// What may come next. "First": directly after a bracket, so that the other bracket may come as well.
enum class Next { Value, FirstValue, Key, FirstKey, Colon, CommaInObject, CommaInArray, End };

constexpr std::array expectedNext{
    N_("a value"),           N_("a value"),    N_("a key in quotes"), N_("a key in quotes"),
    N_("':' after the key"), N_("',' or '}'"), N_("',' or ']'"),      N_("the end of the file")};

constexpr std::string_view decimalDigits = "0123456789";

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

/// What is wrong, and at which byte.
struct Fault {
    std::size_t at = 0;
    Sentence message;
};

/// Reads a text in quotes or a number.
class Lexeme {
public:
    Lexeme(std::string_view text, std::size_t at)
        : text_(text)
        , end_(at) {}

    /// What is wrong with it; none: it ends before end().
    std::optional<Fault> readText() {
        for (++end_; !isEnd();) {
            if (skipped("\""))
                return std::nullopt;
            if (const std::optional<Fault> fault = text_[end_] == '\\' ? readEscape() : readCharacter())
                return fault;
        }
        return fault(Sentence("the file ends in the middle of a text; expected a quote"));
    }

    std::optional<Fault> readNumber() {
        skipped("-");
        bool isWhole = skipped("0") || readDigits();
        if (isWhole && skipped("."))
            isWhole = readDigits();
        if (isWhole && skipped("eE")) {
            skipped("+-");
            isWhole = readDigits();
        }
        if (isWhole)
            return std::nullopt;
        return fault(isEnd() ? Sentence("the file ends in the middle of a number; expected a digit")
                             : Sentence("expected a digit, found {0}", ProperName{wordAt(text_, end_)}));
    }

    [[nodiscard]] std::size_t end() const { return end_; }

private:
    bool isEnd() const { return end_ >= text_.size(); }

    Fault fault(Sentence message) const { return {end_, std::move(message)}; }

    bool skipped(std::string_view any) {
        const bool isThere = !isEnd() && any.find(text_[end_]) != std::string_view::npos;
        end_ += isThere ? 1 : 0;
        return isThere;
    }

    bool readDigits() {
        const std::size_t begin = end_;
        end_ = std::min(text_.find_first_not_of(decimalDigits, end_), text_.size());
        return end_ > begin;
    }

    std::optional<Fault> readCharacter() {
        const auto byte = static_cast<unsigned char>(text_[end_]);
        if (byte == '\n' || byte == '\r')
            return fault(Sentence("the line ends in the middle of a text; expected a quote"));
        if (byte < 0x20)
            return fault(Sentence("expected \\u{0:04x} for a control character in a text", byte));
        const std::size_t bytes = firstCharacter(text_.substr(end_, 4)).bytes;
        if (bytes == 0)
            return fault(Sentence("expected UTF-8, found the byte {0:02X}", byte));
        end_ += bytes;
        return std::nullopt;
    }

    std::optional<Fault> readEscape() {
        const std::size_t begin = end_++;
        if (skipped("\"\\/bfnrt"))
            return std::nullopt;
        if (!skipped("u"))
            return isEnd() ? fault(Sentence("the file ends in the middle of a text; expected a quote"))
                           : fault(Sentence("expected an escape such as \\\" or \\u00e9, found {0}",
                                            ProperName{wordAt(text_, end_)}));
        const std::optional<unsigned> first = readUnit();
        if (!first)
            return fault(Sentence("expected four hexadecimal digits after \\u"));
        if (*first < 0xD800 || *first > 0xDFFF)
            return std::nullopt;
        if (*first <= 0xDBFF && skipped("\\") && skipped("u")) {
            const std::optional<unsigned> second = readUnit();
            if (!second)
                return fault(Sentence("expected four hexadecimal digits after \\u"));
            if (*second >= 0xDC00 && *second <= 0xDFFF)
                return std::nullopt;
        }
        return Fault{begin, Sentence("expected a surrogate pair, such as \\ud83d\\ude00, found one half")};
    }

    /// Four hexadecimal digits.
    std::optional<unsigned> readUnit() {
        unsigned unit = 0;
        for (int i = 0; i < 4; ++i) {
            const std::size_t begin = end_;
            if (!skipped("0123456789abcdefABCDEF"))
                return std::nullopt;
            unsigned digit = 0;
            std::from_chars(text_.data() + begin, text_.data() + end_, digit, 16);
            unit = unit * 16 + digit;
        }
        return unit;
    }

    std::string_view text_;
    std::size_t end_;
};

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
    explicit FaultReader(std::string_view text)
        : text_(text)
        , at_(text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0) {}

    Fault fault() {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
            if (at_ == text_.size())
                return {at_, ended()};
            if (std::optional<Fault> fault = step())
                return *std::move(fault);
        }
    }

private:
    Sentence ended() const {
        const char* what = expectedNext[static_cast<std::size_t>(next_)];
        if (brackets_.empty())
            return next_ == Next::End ? Sentence("expected JSON")
                                      : Sentence("the file ends; expected {0}", what);
        return Sentence("the file ends in the middle of {0}; expected {1}",
                        brackets_.back() == '{' ? N_("an object") : N_("an array"), what);
    }

    Fault refused(const Sentence& found) const {
        return {at_,
                Sentence("expected {0}, found {1}", expectedNext[static_cast<std::size_t>(next_)], found)};
    }

    /// Reads a token.
    std::optional<Fault> step() {
        const char sign = text_[at_];
        const bool isValue = next_ == Next::Value || next_ == Next::FirstValue;
        const bool isKey = next_ == Next::Key || next_ == Next::FirstKey;
        Lexeme lexeme(text_, at_);
        if (sign == '"') {
            if (!isValue && !isKey)
                return refused(N_("a text in quotes"));
            if (std::optional<Fault> fault = lexeme.readText())
                return fault;
            return pass(lexeme.end(), isKey ? Next::Colon : afterValue());
        }
        if (sign == '-' || decimalDigits.find(sign) != std::string_view::npos) {
            if (!isValue)
                return refused(N_("a number"));
            if (std::optional<Fault> fault = lexeme.readNumber())
                return fault;
            return pass(lexeme.end(), afterValue());
        }
        if (isValue && (sign == '{' || sign == '[')) {
            brackets_ += sign;
            return pass(at_ + 1, sign == '{' ? Next::FirstKey : Next::FirstValue);
        }
        if ((sign == '}' && (next_ == Next::FirstKey || next_ == Next::CommaInObject)) ||
            (sign == ']' && (next_ == Next::FirstValue || next_ == Next::CommaInArray))) {
            brackets_.pop_back();
            return pass(at_ + 1, afterValue());
        }
        if (sign == ':' && next_ == Next::Colon)
            return pass(at_ + 1, Next::Value);
        if (sign == ',' && (next_ == Next::CommaInObject || next_ == Next::CommaInArray))
            return pass(at_ + 1, next_ == Next::CommaInObject ? Next::Key : Next::Value);
        if (const std::string_view literal = literalAt(text_, at_); isValue && !literal.empty())
            return pass(at_ + literal.size(), afterValue());
        return refused(ProperName{wordAt(text_, at_)});
    }

    std::optional<Fault> pass(std::size_t end, Next next) {
        at_ = end;
        next_ = next;
        return std::nullopt;
    }

    Next afterValue() const {
        return brackets_.empty()         ? Next::End
               : brackets_.back() == '{' ? Next::CommaInObject
                                         : Next::CommaInArray;
    }

    std::string_view text_;
    std::size_t at_;
    Next next_ = Next::Value;
    std::string brackets_; ///< that are open
};

} // namespace

JsonProblem jsonProblem(std::string_view text, int exception, std::size_t position) {
    constexpr int numberOverflow = 406;
    const Fault fault = exception == numberOverflow
                            ? Fault{std::max<std::size_t>(position, 1) - 1, "expected a smaller number"}
                            : FaultReader(text).fault();
    return {fault.message, atCharacter(text, fault.at)};
}

} // namespace texplorer
