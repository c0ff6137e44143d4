#include "texplorer/image/patterns/pixel_font.h"

#include <algorithm>

namespace texplorer {

namespace {

struct Glyph {
    char character;
    std::string_view rows[glyphHeight]; ///< from the top
};

// Just what the templates write.
constexpr Glyph glyphs[] = {
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    {'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", "  #  ", " #   ", " #   "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    {'A', {" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    {'B', {"#### ", "#   #", "#   #", "#### ", "#   #", "#   #", "#### "}},
    {'C', {" ### ", "#   #", "#    ", "#    ", "#    ", "#   #", " ### "}},
    {'D', {"#### ", "#   #", "#   #", "#   #", "#   #", "#   #", "#### "}},
    {'G', {" ### ", "#   #", "#    ", "# ###", "#   #", "#   #", " ### "}},
    {'L', {"#    ", "#    ", "#    ", "#    ", "#    ", "#    ", "#####"}},
    {'M', {"#   #", "## ##", "# # #", "# # #", "#   #", "#   #", "#   #"}},
    {'O', {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "}},
    {'X', {"#   #", "#   #", " # # ", "  #  ", " # # ", "#   #", "#   #"}},
    {'Y', {"#   #", "#   #", " # # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'Z', {"#####", "    #", "   # ", "  #  ", " #   ", "#    ", "#####"}},
    {'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ####"}},
    {'i', {" # ", "   ", "## ", " # ", " # ", " # ", "###"}},
    {'l', {"## ", " # ", " # ", " # ", " # ", " # ", "###"}},
    {'n', {"     ", "     ", "# ## ", "##  #", "#   #", "#   #", "#   #"}},
    {'p', {"     ", "     ", "#### ", "#   #", "#### ", "#    ", "#    "}},
    {'r', {"    ", "    ", "# ##", "##  ", "#   ", "#   ", "#   "}},
    {'s', {"     ", "     ", " ####", "#    ", " ### ", "    #", "#### "}},
    {'t', {" #  ", " #  ", "### ", " #  ", " #  ", " #  ", "  ##"}},
    {'u', {"     ", "     ", "#   #", "#   #", "#   #", "#  ##", " ## #"}},
    {'x', {"     ", "     ", "#   #", " # # ", "  #  ", " # # ", "#   #"}},
    {'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    {'-', {"     ", "     ", "     ", "#####", "     ", "     ", "     "}},
    {'.', {" ", " ", " ", " ", " ", " ", "#"}},
    {' ', {"  ", "  ", "  ", "  ", "  ", "  ", "  "}},
};

const Glyph& glyphOf(char character) {
    const auto* found = std::ranges::find(glyphs, character, &Glyph::character);
    return found == std::end(glyphs) ? glyphs[std::size(glyphs) - 1] : *found;
}

int advance(const Glyph& glyph) {
    return static_cast<int>(glyph.rows[0].size()) + 1;
}

} // namespace

int textWidth(std::string_view text) {
    int width = 0;
    for (const char character : text)
        width += advance(glyphOf(character));
    return std::max(0, width - 1); // no gap behind the last one
}

void drawText(Canvas& canvas, int x, int y, int scale, std::string_view text, Color color) {
    for (const char character : text) {
        const Glyph& glyph = glyphOf(character);
        for (int row = 0; row < glyphHeight; ++row)
            for (int column = 0; column < advance(glyph) - 1; ++column)
                if (glyph.rows[row][static_cast<std::size_t>(column)] == '#')
                    canvas.fill(x + column * scale, y + (glyphHeight - 1 - row) * scale, scale, scale, color);
        x += advance(glyph) * scale;
    }
}

} // namespace texplorer
