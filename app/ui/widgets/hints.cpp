#include "app/ui/widgets/hints.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/widget_places.h"

#include <fmt/core.h>
#include <imgui.h>

#include <utility>

namespace texplorer::ui {
namespace {

// Global, like Dear ImGui's context, for the frame that is being drawn.
float roomForHints = 0;
Hint hintSaid;

} // namespace

void beginHints(float room) {
    roomForHints = room;
    hintSaid = {};
}

Hint endHints() {
    roomForHints = 0;
    return std::exchange(hintSaid, {});
}

bool fitsBelow(std::string_view words) {
    return roomForHints > 0 && words.find('\n') == std::string_view::npos &&
           ImGui::CalcTextSize(tr(words).c_str()).x <= roomForHints;
}

void hint(std::string words, bool isProblem) {
    noteItem(fmt::format("hint:{}", words));
    hintSaid = {std::move(words), isProblem};
}

} // namespace texplorer::ui
