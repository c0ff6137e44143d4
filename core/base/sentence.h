#pragma once

// Texts for people that can be translated.

#include "texplorer/base/translatable.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace texplorer {

/// A text in a sentence that is never translated: of a file, a model, a parameter's path.
struct ProperName {
    std::string_view text;
};

/// A text for people: English, with its key and the arguments that were inserted, from which a translation is
/// made. `Sentence("expected {0} bytes, found {1}", 54, 3)`. Equal sentences have the same English text.
class Sentence {
public:
    /// The key, checked when it is compiled: each placeholder has the number of an argument, and, if that is
    /// a number, maybe a format of the fmt library, "{0:.2f}".
    template<class... Arguments>
    struct Key {
        template<std::convertible_to<std::string_view> Text>
        consteval Key(const Text& key) // implicit, so that a literal can be passed
            : text(key) {
            check(text, std::array{kindOf<Arguments>()...});
        }
        std::string_view text;
    };

    Sentence() = default;
    /// A text that is its own key.
    Sentence(std::string english)
        : english_(std::move(english)) {}
    Sentence(std::string_view english)
        : english_(english) {}
    Sentence(const char* english)
        : english_(english) {}
    Sentence(ProperName name)
        : english_(name.text)
        , is_(Is::Name) {}
    /// Arguments are numbers, texts, names and sentences.
    template<class First, class... Rest>
    Sentence(Key<std::type_identity_t<First>, std::type_identity_t<Rest>...> key, const First& first,
             const Rest&... rest)
        : key_(key.text)
        , arguments_(1 + sizeof...(rest)) {
        write(std::array{valueOf(first), valueOf(rest)...});
    }

    /// `one` if the number is 1, else `many`: plural("{0} byte", "{0} bytes", 3).
    template<std::integral Number, class... Rest>
    [[nodiscard]] static Sentence
    plural(Key<std::type_identity_t<Number>, std::type_identity_t<Rest>...> one,
           Key<std::type_identity_t<Number>, std::type_identity_t<Rest>...> many, Number number,
           const Rest&... rest) {
        return {number == 1 ? one : many, number, rest...};
    }

    /// The same as one that was taken apart, as to send it to another process. `key` has to be a literal.
    [[nodiscard]] static Sentence ofParts(std::string_view key, std::vector<Sentence> arguments);

    /// The same of an argument that was a number, with its text; `whole`: its number().
    [[nodiscard]] static Sentence ofNumber(std::string text, std::optional<std::uint64_t> whole);

    /// Joins two at a time: joined("{0}, {1}", all). Empty for none.
    [[nodiscard]] static Sentence joined(Key<Sentence, Sentence> pair, std::span<const Sentence> all);

    [[nodiscard]] const std::string& english() const { return english_; }
    operator const std::string&() const { return english_; }
    operator std::string_view() const { return english_; }
    [[nodiscard]] bool empty() const { return english_.empty(); }

    /// "expected {0} bytes, found {1}"; empty for a text that is its own key.
    [[nodiscard]] std::string_view key() const { return key_; }
    /// What replaces "{0}", "{1}"…, with its format.
    [[nodiscard]] const std::vector<Sentence>& arguments() const { return arguments_; }
    /// Inserts the arguments, each as `text` returns it, into another form of the key, as a translation.
    [[nodiscard]] std::string in(std::string_view form,
                                 const std::function<std::string(const Sentence&)>& text) const;
    /// An argument that is a whole number, for plural forms.
    [[nodiscard]] std::optional<std::uint64_t> number() const { return number_; }
    /// An argument that is a number; its text has the digits that its format keeps.
    [[nodiscard]] bool isNumber() const { return is_ == Is::Number; }
    [[nodiscard]] bool isName() const { return is_ == Is::Name; }

    friend bool operator==(const Sentence& a, const Sentence& b) { return a.english_ == b.english_; }
    friend std::ostream& operator<<(std::ostream& out, const Sentence& sentence);

private:
    enum class Kind { Text, Whole, Real };
    enum class Is : std::uint8_t { Text, Name, Number };
    using Value = std::variant<std::string_view, ProperName, const Sentence*, bool, char, std::int64_t,
                               std::uint64_t, float, double>;

    template<class Argument>
    static consteval Kind kindOf() {
        return std::floating_point<Argument> ? Kind::Real
               : std::integral<Argument>     ? Kind::Whole
                                             : Kind::Text;
    }

    template<class Argument>
    static Value valueOf(const Argument& argument) {
        if constexpr (std::same_as<Argument, Sentence>)
            return &argument;
        else if constexpr (std::same_as<Argument, bool> || std::same_as<Argument, char> ||
                           std::same_as<Argument, ProperName> || std::floating_point<Argument>)
            return argument;
        else if constexpr (std::signed_integral<Argument>)
            return std::int64_t{argument};
        else if constexpr (std::unsigned_integral<Argument>)
            return std::uint64_t{argument};
        else
            return std::string_view(argument);
    }

    // Not constant, so that a key for which one of them is called doesn't compile.
    static void placeholderHasNoArgument() {}
    static void formatIsNotOfANumber() {}

    template<std::size_t count>
    static constexpr void check(std::string_view key, const std::array<Kind, count>& kinds) {
        for (std::size_t i = 0; i < key.size(); ++i) {
            if (key[i] != '{' && key[i] != '}')
                continue;
            if (i + 1 < key.size() && key[i + 1] == key[i]) {
                ++i;
                continue;
            }
            const std::size_t end = key.find('}', i);
            const auto number = i + 1 < key.size() ? static_cast<std::size_t>(key[i + 1] - '0') : count;
            if (key[i] == '}' || end == std::string_view::npos || number >= count)
                return placeholderHasNoArgument();
            if (end > i + 2)
                checkFormat(key.substr(i + 2, end - i - 2), kinds[number]);
            i = end;
        }
    }

    static constexpr void checkFormat(std::string_view format, Kind kind) {
        const std::string_view types = kind == Kind::Real ? "0123456789aefg" : "0123456789bdoxX";
        if (format.front() != ':' || kind == Kind::Text || format.size() < 2 ||
            types.find(format.back()) == std::string_view::npos)
            formatIsNotOfANumber();
    }

    void write(std::span<const Value> values);

    std::string english_;
    std::string_view key_; ///< a literal
    std::vector<Sentence> arguments_;
    std::optional<std::uint64_t> number_;
    Is is_ = Is::Text;
};

} // namespace texplorer
