#include "core/base/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace texplorer {
namespace {

constexpr std::size_t longestName = 64;

char smallLetter(char c) {
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
            const std::size_t replaced = diagonal + (smallLetter(a[i]) == smallLetter(b[j]) ? 0 : 1);
            diagonal = costs[j + 1];
            costs[j + 1] = std::min({replaced, costs[j] + 1, costs[j + 1] + 1});
        }
    }
    return costs.back();
}

} // namespace

std::vector<std::string_view> nearestNames(std::string_view text,
                                           const std::vector<std::string_view>& names) {
    std::vector<std::string_view> nearest;
    if (text.size() > longestName)
        return nearest;
    std::size_t least = text.size() < 4 ? 1 : text.size() / 3; // the farthest that counts as close
    for (const std::string_view name : names) {
        const std::size_t distance = editDistance(text, name);
        if (distance > least)
            continue;
        if (distance < least)
            nearest.clear();
        least = distance;
        nearest.push_back(name);
    }
    return nearest;
}

std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names) {
    const std::vector<std::string_view> nearest = nearestNames(text, names);
    return nearest.empty() ? std::string_view() : nearest.front();
}

} // namespace texplorer
