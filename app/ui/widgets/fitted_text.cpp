#include "app/ui/widgets/fitted_text.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/wrapped_text.h"
#include "texplorer/text/printable.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

float widthOf(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

std::string cutToFit(std::string_view text, float room) {
    if (widthOf(text) <= room)
        return std::string(text);
    // The longest beginning that leaves room for the dots, by binary search.
    const float left = room - widthOf("…");
    std::size_t fits = 0;
    std::size_t tooLong = text.size();
    while (tooLong - fits > 1) {
        const std::size_t middle = (fits + tooLong) / 2;
        (widthOf(text.substr(0, middle)) <= left ? fits : tooLong) = middle;
    }
    return std::string(text.substr(0, sensibleEnd(text, beginningOf(text, fits).size()))) + "…";
}

} // namespace

std::size_t sensibleEnd(std::string_view text, std::size_t fits) {
    constexpr std::size_t label = 16; // every letter of a short text counts
    if (fits >= text.size())
        return text.size();
    if (fits < label)
        return fits;
    const std::string_view room = text.substr(0, fits + 1);
    std::size_t clause = 0;
    for (const std::string_view mark : {"; ", ": ", ", ", ". "}) {
        const std::size_t at = room.rfind(mark);
        if (at != std::string_view::npos)
            clause = std::max(clause, at);
    }
    if (2 * clause >= fits)
        return clause;
    const std::size_t space = room.rfind(' ');
    return space != std::string_view::npos && 2 * space >= fits ? space : fits;
}

std::string fitted(const Sentence& words, float room) {
    return cutToFit(tr(words), room);
}

bool fittedText(const Sentence& words, ImU32 ink) {
    const std::string whole = printable(tr(words));
    const std::string shown = cutToFit(whole, ImGui::GetContentRegionAvail().x);
    plainText(shown, ink);
    return shown != whole;
}

} // namespace texplorer::ui
