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

} // namespace

void Sentence::write(std::span<const Value> values) {
    const auto argumentOf = [](std::string_view placeholder, const auto& value) -> Sentence {
        using Type = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::same_as<Type, const Sentence*>) {
            return *value;
        } else if constexpr (std::same_as<Type, std::string_view> || std::same_as<Type, ProperName>) {
            return value;
        } else {
            Sentence number = formatted(placeholder, value);
            number.isName_ = std::floating_point<Type>;
            if constexpr (std::same_as<Type, std::int64_t> || std::same_as<Type, std::uint64_t>)
                number.number_ = static_cast<std::uint64_t>(value);
            return number;
        }
    };
    for (std::size_t i = 0; i < key_.size(); ++i) {
        if (key_[i] != '{' || key_[i + 1] == '{') {
            english_ += key_[i];
            i += key_[i] == '{' || key_[i] == '}'; // doubled
            continue;
        }
        const std::size_t end = key_.find('}', i);
        const auto index = static_cast<std::size_t>(key_[i + 1] - '0');
        Sentence& argument = arguments_[index];
        argument = std::visit(
            [&](const auto& value) { return argumentOf(key_.substr(i, end + 1 - i), value); }, values[index]);
        english_ += argument.english_;
        i = end;
    }
}

std::ostream& operator<<(std::ostream& out, const Sentence& sentence) {
    return out << sentence.english_;
}

} // namespace texplorer
