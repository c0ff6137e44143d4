#include "texplorer/text/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace texplorer {
namespace {

constexpr std::size_t maxNameBytes = 64;
constexpr std::size_t minLetters = 3; ///< of a beginning

char smallLetter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// How many letters to insert, drop, replace or swap with their neighbours: Levenshtein's distance with
/// Damerau's swaps, of which none overlap.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1); // the costs of two letters of a ago, and of one
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> costs(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    const auto same = [](char c, char d) { return smallLetter(c) == smallLetter(d); };
    for (std::size_t i = 0; i < a.size(); ++i) {
        costs[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            costs[j + 1] = std::min({last[j] + (same(a[i], b[j]) ? 0 : 1), costs[j] + 1, last[j + 1] + 1});
            if (i > 0 && j > 0 && same(a[i], b[j - 1]) && same(a[i - 1], b[j]))
                costs[j + 1] = std::min(costs[j + 1], before[j - 1] + 1);
        }
        before.swap(last);
        last.swap(costs);
    }
    return last.back();
}

bool beginsWith(std::string_view name, std::string_view text) {
    return name.size() > text.size() &&
           std::ranges::equal(text, name.substr(0, text.size()), {}, smallLetter, smallLetter);
}

} // namespace

std::vector<std::string_view> nearestNames(std::string_view text,
                                           const std::vector<std::string_view>& names) {
    std::vector<std::string_view> nearest;
    if (text.size() > maxNameBytes)
        return nearest;
    if (text.size() >= minLetters)
        std::ranges::copy_if(names, std::back_inserter(nearest),
                             [&](std::string_view name) { return beginsWith(name, text); });
    if (!nearest.empty())
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
