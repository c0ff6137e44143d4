#include "app/ui/widgets/wrapped_text.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/line_breaks.h"

#include <imgui_internal.h> // the window's wrap position

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr std::size_t maxWordLength = 160; // in bytes
constexpr std::size_t maxTextLength = 4000;
constexpr std::size_t maxRemembered = 4000; // texts

bool isInsideLetter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; // of a UTF-8 sequence 10xxxxxx
}

std::string_view endOf(std::string_view text, std::size_t bytes) {
    std::size_t from = text.size() - bytes;
    while (from < text.size() && isInsideLetter(text[from]))
        ++from;
    return text.substr(from);
}

/// Chinese has no blanks, and its clauses are not words.
bool isLatin(std::string_view word) {
    return word.find_first_of("\xE3\xE4\xE5\xE6\xE7\xE8\xE9\xEF") == std::string_view::npos;
}

/// The last layout of a text: most texts stay the same from frame to frame.
struct Wrapped {
    const ImFont* font = nullptr;
    float size = 0;
    float room = -1;
    std::string lines{}; ///< with a line end between them
};

struct WordsHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view words) const { return std::hash<std::string_view>()(words); }
};
std::unordered_map<std::string, std::vector<Wrapped>, WordsHash, std::equal_to<>> wrappedBefore;

std::string wrappedAt(std::string_view words, float room, const ImFont& font, float size) {
    const auto widthOf = [&](std::string_view part) {
        return font.CalcTextSizeA(size, FLT_MAX, 0, part.data(), part.data() + part.size()).x;
    };
    const std::string readable = readablePart(words);
    std::string lines;
    constexpr float rounding = 0.05F; // a text as wide as its column fits
    for (const std::string_view line : linesOf(readable, room + rounding, widthOf)) {
        lines += line;
        lines += '\n';
    }
    lines.pop_back();
    return lines;
}

const std::string& wrapped(std::string_view words, float room) {
    constexpr std::size_t places = 32; // for the same text in columns of several widths
    const ImFont* font = ImGui::GetFont();
    const float size = ImGui::GetFontSize();
    if (wrappedBefore.size() > maxRemembered)
        wrappedBefore.clear();
    auto found = wrappedBefore.find(words);
    if (found == wrappedBefore.end())
        found = wrappedBefore.emplace(words, std::vector<Wrapped>()).first;
    std::vector<Wrapped>& known = found->second;
    for (const Wrapped& each : known) {
        if (each.font == font && each.size == size && each.room == room)
            return each.lines;
    }
    if (known.size() == places)
        known.erase(known.begin());
    return known.emplace_back(Wrapped{font, size, room, wrappedAt(words, room, *font, size)}).lines;
}

void drawAsItIs(std::string_view words) {
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

} // namespace

std::string_view beginningOf(std::string_view text, std::size_t bytes) {
    while (bytes > 0 && isInsideLetter(text[bytes]))
        --bytes;
    return text.substr(0, bytes);
}

std::string readablePart(std::string_view words) {
    std::string shown;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find_first_of(" \n"), words.size());
        const std::string_view word = words.substr(0, end);
        if (word.size() > maxWordLength && isLatin(word))
            shown.append(beginningOf(word, maxWordLength / 2))
                .append("…")
                .append(endOf(word, maxWordLength / 3));
        else
            shown += word;
        if (end < words.size())
            shown += words[end];
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    if (shown.size() > maxTextLength)
        shown = std::string(beginningOf(shown, maxTextLength)) + "…";
    return shown;
}

void plainText(std::string_view words) {
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    if (window.DC.TextWrapPos < 0)
        return words.size() > maxTextLength ? drawAsItIs(readablePart(words)) : drawAsItIs(words);
    const float room = ImGui::CalcWrapWidthForPos(window.DC.CursorPos, window.DC.TextWrapPos);
    ImGui::PushTextWrapPos(-1);
    drawAsItIs(wrapped(words, room));
    ImGui::PopTextWrapPos();
}

void plainText(std::string_view words, ImU32 ink) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    plainText(words);
    ImGui::PopStyleColor();
}

void dimPlainText(std::string_view words) {
    plainText(words, color::dim);
}

void plainWrappedText(std::string_view words) {
    const bool isWrapped = ImGui::GetCurrentWindow()->DC.TextWrapPos >= 0;
    if (!isWrapped)
        ImGui::PushTextWrapPos(0);
    plainText(words);
    if (!isWrapped)
        ImGui::PopTextWrapPos();
}

void plainWrappedText(std::string_view words, ImU32 ink) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    plainWrappedText(words);
    ImGui::PopStyleColor();
}

void text(const Sentence& words) {
    plainText(tr(words));
}

void text(const Sentence& words, ImU32 ink) {
    plainText(tr(words), ink);
}

void dimText(const Sentence& words) {
    text(words, color::dim);
}

void labelText(const Sentence& words, ImU32 ink) {
    ImGui::AlignTextToFramePadding();
    text(words, ink);
}

void wrappedText(const Sentence& words) {
    plainWrappedText(tr(words));
}

void wrappedText(const Sentence& words, ImU32 ink) {
    plainWrappedText(tr(words), ink);
}

void dimWrappedText(const Sentence& words) {
    wrappedText(words, color::dim);
}

void caption(const Sentence& words) {
    const float em = ImGui::GetFontSize();
    ImGui::Dummy({0, em * 0.15F});
    text(words, color::text); // the dim colour means that something has no effect
    const float left = ImGui::GetItemRectMax().x + em * 0.5F;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float middle = std::round((ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y) / 2);
    if (left < right)
        ImGui::GetWindowDrawList()->AddLine({left, middle}, {right, middle},
                                            ImGui::GetColorU32(ImGuiCol_Separator), std::max(1.0F, em / 15));
}

void forgetWrappedTexts() {
    wrappedBefore.clear();
}

std::string wrappedLines(std::string_view words, float room) {
    return wrapped(words, room);
}

ImVec2 wrappedSize(std::string_view words, float room) {
    return ImGui::CalcTextSize(wrapped(words, room).c_str());
}

} // namespace texplorer::ui
