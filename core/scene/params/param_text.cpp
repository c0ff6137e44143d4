#include "core/scene/params/param_text.h"

#include "core/base/printable.h"
#include "core/base/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <numeric>

namespace texplorer {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Levenshtein's distance: how many letters to insert, drop or replace.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> costs(b.size() + 1);
    std::iota(costs.begin(), costs.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = costs[0];
        costs[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = costs[j + 1];
            costs[j + 1] = std::min({replaced, costs[j] + 1, costs[j + 1] + 1});
        }
    }
    return costs.back();
}

} // namespace

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
    constexpr std::size_t longest = 40;
    std::string out;
    while (!text.empty()) {
        if (out.size() >= longest)
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

std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names) {
    std::string_view best;
    std::size_t bestDistance = text.size() < 4 ? 2 : text.size() / 3 + 1; // one beyond what counts as close
    if (text.size() > 64)
        return best;
    for (const std::string_view name : names) {
        const std::size_t distance = editDistance(text, name);
        if (distance < bestDistance) {
            best = name;
            bestDistance = distance;
        }
    }
    return best;
}

std::string suggestName(std::string_view text, const std::vector<std::string_view>& names) {
    if (const std::string_view near = nearestName(text, names); !near.empty())
        return fmt::format("did you mean {}?", inQuotes(near));
    std::string all;
    for (const std::string_view name : names)
        all.append(all.empty() ? "" : ", ").append(name);
    return fmt::format("expected one of {}", all);
}

} // namespace texplorer
