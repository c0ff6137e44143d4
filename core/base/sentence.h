#pragma once

// Texts for people that can be translated.

#include <fmt/core.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
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
    /// The key, checked when it is compiled: placeholders are numbered and may have a format, "{0:.2f}".
    template<class... Arguments>
    struct Key {
        template<std::convertible_to<std::string_view> Text>
        consteval Key(const Text& key) // implicit, as fmt::format_string is
            : text(key) {
            static_cast<void>(fmt::format_string<Arguments...>(key));
            checkNumbers(text);
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
        , isName_(true) {}
    template<class First, class... Rest>
    Sentence(Key<std::type_identity_t<First>, std::type_identity_t<Rest>...> key, const First& first,
             const Rest&... rest)
        : key_(key.text)
        , arguments_(1 + sizeof...(rest)) {
        write(fmt::make_format_args(first, rest...));
        auto formatted = arguments_.begin();
        setArgument(*formatted++, first);
        (setArgument(*formatted++, rest), ...);
    }

    [[nodiscard]] const std::string& english() const { return english_; }
    operator const std::string&() const { return english_; }
    operator std::string_view() const { return english_; }
    [[nodiscard]] bool empty() const { return english_.empty(); }

    /// "expected {0} bytes, found {1}"; empty for a text that is its own key.
    [[nodiscard]] std::string_view key() const { return key_; }
    /// What replaces "{0}", "{1}"…, with its format.
    [[nodiscard]] const std::vector<Sentence>& arguments() const { return arguments_; }
    /// An argument that is a whole number, for plural forms.
    [[nodiscard]] std::optional<std::uint64_t> number() const { return number_; }
    [[nodiscard]] bool isName() const { return isName_; }

    friend bool operator==(const Sentence& a, const Sentence& b) { return a.english_ == b.english_; }
    friend std::ostream& operator<<(std::ostream& out, const Sentence& sentence);

private:
    void write(fmt::format_args arguments);

    /// Not constant, so that a wrong key doesn't compile.
    static void placeholderWithoutNumber() {}
    static constexpr void checkNumbers(std::string_view key) {
        for (std::size_t i = 0; i + 1 < key.size(); ++i) {
            if (key[i] != '{')
                continue;
            if (key[i + 1] == '{')
                ++i;
            else if (key[i + 1] < '0' || key[i + 1] > '9')
                placeholderWithoutNumber();
        }
    }

    template<class Argument>
    void setArgument(Sentence& formatted, const Argument& argument) {
        if constexpr (std::same_as<Argument, Sentence>)
            formatted = argument;
        else if constexpr (std::integral<Argument> && !std::same_as<Argument, bool> &&
                           !std::same_as<Argument, char>)
            formatted.number_ = static_cast<std::uint64_t>(argument);
        else
            formatted.isName_ = std::same_as<Argument, ProperName> || std::floating_point<Argument>;
    }

    std::string english_;
    std::string_view key_; ///< a literal
    std::vector<Sentence> arguments_;
    std::optional<std::uint64_t> number_;
    bool isName_ = false;
};

} // namespace texplorer

template<>
struct fmt::formatter<texplorer::Sentence> {
    static constexpr auto parse(format_parse_context& context) { return context.begin(); }
    static auto format(const texplorer::Sentence& sentence, format_context& context) {
        return format_to(context.out(), "{}", sentence.english());
    }
};

template<>
struct fmt::formatter<texplorer::ProperName> {
    static constexpr auto parse(format_parse_context& context) { return context.begin(); }
    static auto format(const texplorer::ProperName& name, format_context& context) {
        return format_to(context.out(), "{}", name.text);
    }
};
