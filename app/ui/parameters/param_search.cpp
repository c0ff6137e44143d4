#include "app/ui/parameters/param_search.h"

#include "app/ui/parameters/param_places.h"
#include "app/ui/widgets/param_tips.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace texplorer::ui {
namespace {

char lower(char letter) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

bool contains(std::string_view text, std::string_view part) {
    const auto same = [](char a, char b) { return lower(a) == lower(b); };
    return !std::ranges::search(text, part, same).empty();
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
    if (contains(row.label, word) || contains(row.key, word) || contains(row.group, word) ||
        contains(glNameOf(row), word))
        return 2;
    const bool isChoice = std::ranges::any_of(row.choices, [&](const EnumRow& choice) {
        return contains(choice.label, word) || contains(choice.name, word);
    });
    return isChoice || contains(row.glCall, word) || contains(row.help, word) ? 1 : 0;
}

} // namespace

int matchOf(const ParamRow& row, std::string_view words) {
    const std::vector<std::string_view> all = wordsOf(words);
    int least = all.empty() || isList(row.kind) ? 0 : 2;
    for (const std::string_view word : all)
        least = std::min(least, matchOfWord(row, word));
    return least;
}

void searchResults(Session& session, std::string_view words) {
    std::size_t found = 0;
    for (const int wanted : {2, 1}) {
        for (const ShownStruct& place : paramPlaces(session)) {
            bool titled = false;
            for (const ParamRow& row : place.table->params) {
                if (matchOf(row, words) != wanted)
                    continue;
                if (!std::exchange(titled, true)) {
                    const char* tab = rowOf(rowOf(place.section).tab).label;
                    caption(place.title.empty() || place.title == tab
                                ? std::string(tab)
                                : fmt::format("{} · {}", tab, place.title));
                    noteItem(fmt::format("found in:{}", tab));
                }
                ++found;
                if (paramWidget(session, place.owner, row) && mayMoveLists(row))
                    return; // the rest is drawn at the next frame
            }
        }
    }
    if (found == 0)
        ImGui::TextWrapped(
            "No parameter has such a name: neither its label, nor OpenGL's name for it, nor its "
            "choices, nor its help.");
    noteItem(fmt::format("found:{}", found));
}

} // namespace texplorer::ui
