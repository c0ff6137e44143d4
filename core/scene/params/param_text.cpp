#include "texplorer/scene/params/param_text.h"

#include "texplorer/text/nearest_name.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace texplorer {

std::string formatNumber(float number) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

std::string formatNumbers(std::span<const float> numbers, std::string_view separator) {
    std::string text;
    for (const float number : numbers)
        text.append(text.empty() ? "" : separator).append(formatNumber(number));
    return text;
}

std::string shortened(std::string_view text) {
    constexpr std::size_t maxNameBytes = 40;
    std::string out;
    while (!text.empty()) {
        if (out.size() >= maxNameBytes)
            return out + "...";
        const std::size_t bytes = std::max<std::size_t>(firstCharacter(text).bytes, 1);
        out += printable(text.substr(0, bytes));
        text.remove_prefix(bytes);
    }
    return out;
}

std::string inQuotes(std::string_view text) {
    return '"' + shortened(text) + '"';
}

Sentence suggestName(std::string_view text, const std::vector<std::string_view>& names) {
    if (const std::string_view near = nearestName(text, names); !near.empty())
        return Sentence("did you mean {0}?", ProperName{inQuotes(near)});
    std::string all;
    for (const std::string_view name : names)
        all.append(all.empty() ? "" : ", ").append(name);
    return Sentence("expected one of {0}", ProperName{all});
}

} // namespace texplorer
