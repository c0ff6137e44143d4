#include "app/ui/model/param_match.h"
#include "app/ui/parameters/sections.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace texplorer::ui {

void searchResults(const Session& session, std::string_view words) {
    std::size_t found = 0;
    for (const int wanted : {2, 1}) {
        for (const ShownStruct& place : shownStructs(session)) {
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
                paramWidget(session, place.owner, row);
            }
        }
    }
    if (found == 0)
        wrappedText("No parameter matches: the label, OpenGL's name, the choices and the help are searched.");
    noteItem(fmt::format("found:{}", found));
}

} // namespace texplorer::ui
