#include "tests/ui/drawn_texts.h"

#include "app/ui/widgets/fonts.h"

#include <imgui_internal.h> // letters as UTF-8

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace texplorer::test {
namespace {

struct Letter {
    const ImFontGlyph* glyph;
    const ImFont* font;
};
using Letters = std::map<std::pair<float, float>, Letter>; // by the corner of its rectangle in the atlas

/// Those of the present fonts, which are the same for many frames.
const Letters& lettersOfFonts() {
    static Letters letters;
    static std::vector<const void*> known;
    std::vector<const void*> present;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        present.insert(present.end(), {font, font->Glyphs.begin(), font->Glyphs.end()});
    if (present == known)
        return letters;
    known = std::move(present);
    letters.clear();
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
        for (const ImFontGlyph& glyph : font->Glyphs)
            letters.try_emplace({glyph.U0, glyph.V0}, Letter{&glyph, font});
    }
    return letters;
}

/// Joins the letters of a line.
class Line {
public:
    explicit Line(std::vector<std::string>& texts)
        : texts_(texts) {}
    ~Line() { end(); }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    void add(const Letter& letter, const ImDrawVert& from, const ImDrawVert& to) {
        const ImFontGlyph& glyph = *letter.glyph;
        const float scale = (to.pos.x - from.pos.x) / (glyph.X1 - glyph.X0);
        const float left = from.pos.x - glyph.X0 * scale;
        const float top = from.pos.y - glyph.Y0 * scale;
        const float gap = left - right_;
        const float space = letter.font->FindGlyph(' ')->AdvanceX * scale;
        if (letter.font != font_ || std::abs(top - top_) > 1 || gap < -1 || gap > space * 1.5F)
            end();
        else if (gap > space * 0.5F)
            text_ += ' ';
        std::array<char, 5> bytes{};
        text_ += ImTextCharToUtf8(bytes.data(), glyph.Codepoint);
        font_ = letter.font;
        top_ = top;
        right_ = left + glyph.AdvanceX * scale;
    }

    void end() {
        if (!text_.empty() && font_ != ui::codeFont())
            texts_.push_back(text_);
        text_.clear();
    }

private:
    std::vector<std::string>& texts_;
    std::string text_;
    const ImFont* font_ = nullptr;
    float top_ = 0;
    float right_ = 0;
};

bool isQuad(const ImVector<ImDrawIdx>& indices, int at) {
    const int first = indices[at];
    return at + 5 < indices.Size && indices[at + 1] == first + 1 && indices[at + 2] == first + 2 &&
           indices[at + 3] == first && indices[at + 4] == first + 2 && indices[at + 5] == first + 3;
}

void readList(const ImDrawList& list, const Letters& letters, Line& line) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const auto end = static_cast<int>(command.IdxOffset + command.ElemCount);
        for (int i = static_cast<int>(command.IdxOffset); i < end; i += 3) {
            if (!isQuad(list.IdxBuffer, i))
                continue;
            const ImDrawVert* corners =
                list.VtxBuffer.Data + command.VtxOffset + static_cast<unsigned>(list.IdxBuffer[i]);
            const auto letter = letters.find({corners[0].uv.x, corners[0].uv.y});
            if (letter == letters.end())
                continue;
            line.add(letter->second, corners[0], corners[2]);
            i += 3;
        }
        line.end();
    }
}

} // namespace

std::vector<std::string> drawnTexts() {
    const Letters& letters = lettersOfFonts();
    std::vector<std::string> texts;
    Line line(texts);
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int i = 0; i < drawn.CmdListsCount; ++i)
        readList(*drawn.CmdLists[i], letters, line);
    return texts;
}

} // namespace texplorer::test
