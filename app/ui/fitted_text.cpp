#include "app/ui/fitted_text.h"

#include <string>

namespace texplorer::ui {
namespace {

bool isContinuation(char letter) {
    return (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U; // of a UTF-8 sequence 10xxxxxx
}

float widthOf(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

} // namespace

bool fittedText(std::string_view text, ImU32 ink) {
    const float room = ImGui::GetContentRegionAvail().x;
    std::string shown(text);
    const bool cut = widthOf(text) > room;
    if (cut) {
        // The longest beginning that leaves room for the dots: searched by halves, a character costs nothing.
        const float left = room - widthOf("…");
        std::size_t fits = 0;
        std::size_t tooLong = text.size();
        while (tooLong - fits > 1) {
            const std::size_t middle = (fits + tooLong) / 2;
            (widthOf(text.substr(0, middle)) <= left ? fits : tooLong) = middle;
        }
        while (fits > 0 && isContinuation(text[fits]))
            --fits;
        shown = std::string(text.substr(0, fits)) + "…";
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopStyleColor();
    return cut;
}

} // namespace texplorer::ui
