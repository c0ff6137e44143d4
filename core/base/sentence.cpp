#include "texplorer/base/sentence.h"

#include <fmt/core.h>

#include <ostream>

namespace texplorer {
namespace {

/// A value with the format of its placeholder, "{1:.2f}".
std::string formatted(std::string_view placeholder, const auto& value) {
    const std::size_t colon = placeholder.find(':');
    const std::string format =
        colon == std::string_view::npos ? "{}" : "{" + std::string(placeholder.substr(colon));
    return fmt::vformat(format, fmt::make_format_args(value));
}

/// Appends a form's text to `out`, and calls `insert` with the number and the whole of each placeholder.
void eachPart(std::string_view form, std::string& out, const auto& insert) {
    for (std::size_t i = 0; i < form.size(); ++i) {
        const std::size_t end = form.find('}', i);
        if (form[i] != '{' || end == std::string_view::npos || form[i + 1] == '{') {
            out += form[i];
            i += i + 1 < form.size() && (form[i] == '{' || form[i] == '}') &&
                 form[i + 1] == form[i]; // doubled
            continue;
        }
        insert(static_cast<std::size_t>(form[i + 1] - '0'), form.substr(i, end + 1 - i));
        i = end;
    }
}

} // namespace

std::string Sentence::in(std::string_view form,
                         const std::function<std::string(const Sentence&)>& text) const {
    std::string filled;
    eachPart(form, filled, [&](std::size_t index, std::string_view) {
        filled += index < arguments_.size() ? text(arguments_[index]) : std::string();
    });
    return filled;
}

void Sentence::write(std::span<const Value> values) {
    eachPart(key_, english_, [&](std::size_t index, std::string_view placeholder) {
        const auto argumentOf = [&](const auto& value) -> Sentence {
            using Type = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::same_as<Type, const Sentence*>) {
                return *value;
            } else if constexpr (std::same_as<Type, std::string_view> || std::same_as<Type, ProperName>) {
                return value;
            } else {
                Sentence number = formatted(placeholder, value);
                if constexpr (!std::same_as<Type, bool> && !std::same_as<Type, char>)
                    number.is_ = Is::Number;
                if constexpr (std::same_as<Type, std::int64_t> || std::same_as<Type, std::uint64_t>)
                    number.number_ = static_cast<std::uint64_t>(value);
                return number;
            }
        };
        arguments_[index] = std::visit(argumentOf, values[index]);
        english_ += arguments_[index].english_;
    });
}

Sentence Sentence::ofNumber(std::string text, std::optional<std::uint64_t> whole) {
    Sentence number(std::move(text));
    number.number_ = whole;
    number.is_ = Is::Number;
    return number;
}

Sentence Sentence::ofParts(std::string_view key, std::vector<Sentence> arguments) {
    Sentence whole;
    whole.key_ = key;
    whole.arguments_ = std::move(arguments);
    whole.english_ = whole.in(key, &Sentence::english);
    return whole;
}

Sentence Sentence::joined(Key<Sentence, Sentence> pair, std::span<const Sentence> all) {
    Sentence text;
    for (const Sentence& each : all)
        text = text.empty() ? each : Sentence(pair, text, each);
    return text;
}

std::ostream& operator<<(std::ostream& out, const Sentence& sentence) {
    return out << sentence.english_;
}

} // namespace texplorer
