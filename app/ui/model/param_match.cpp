#include "app/ui/model/param_match.h"

#include "app/ui/language/translate.h"
#include "texplorer/scene/params/param_text.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace texplorer::ui {
namespace {

/// Lower case for Latin and Russian letters; Russian capitals are D0 90 to D0 AF and D0 81 in UTF-8.
std::string lowered(std::string_view text) {
    std::string lower(text);
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const auto letter = static_cast<unsigned char>(lower[i]);
        if (letter < 0x80) {
            lower[i] = static_cast<char>(std::tolower(letter));
            continue;
        }
        if (letter != 0xD0 || i + 1 == lower.size())
            continue;
        const auto second = static_cast<unsigned char>(lower[i + 1]);
        const bool isHigh = second >= 0xA0 && second <= 0xAF; // its small letter is D1 80 to D1 8F
        if (second >= 0x90 && second < 0xA0)
            lower[i + 1] = static_cast<char>(second + 0x20);
        else if (isHigh)
            lower[i + 1] = static_cast<char>(second - 0x20);
        else if (second == 0x81)
            lower[i + 1] = static_cast<char>(0x91);
        if (isHigh || second == 0x81)
            lower[i] = static_cast<char>(0xD1);
        ++i;
    }
    return lower;
}

/// `word` is in lower case.
bool contains(std::string_view text, std::string_view word) {
    return lowered(text).find(word) != std::string::npos;
}

/// In English or in the window's language.
bool isSaid(std::string_view english, std::string_view word) {
    return contains(english, word) || (catalogueInUse() && contains(tr(english), word));
}

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0)
            words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

int matchOfWord(const ParamRow& row, std::string_view word) {
    if (isSaid(row.label, word) || contains(row.key, word) || isSaid(row.group, word) ||
        contains(glNameOf(row), word))
        return 2;
    const bool isChoice = std::ranges::any_of(row.choices, [&](const EnumRow& choice) {
        return isSaid(choice.label, word) || contains(choice.name, word);
    });
    return isChoice || contains(row.glCall, word) || isSaid(row.help, word) ? 1 : 0;
}

} // namespace

int matchOf(const ParamRow& row, std::string_view words) {
    const std::string wanted = lowered(words);
    const std::vector<std::string_view> all = wordsOf(wanted);
    int least = all.empty() || isList(row.kind) ? 0 : 2;
    for (const std::string_view word : all)
        least = std::min(least, matchOfWord(row, word));
    return least;
}

} // namespace texplorer::ui
