#pragma once

#include "app/ui/language/catalogue.h"

#include <imgui.h>

#include <cstddef>
#include <set>

namespace texplorer::ui {

/// Letters that the fonts of a window have beyond those of its language: of names from outside, in whatever
/// script. Dear ImGui has only the letters that an atlas was built with, so each is loaded once it has been
/// drawn; a name is right two frames after it was first seen.
class Letters {
public:
    /// Looks for letters in what was drawn that the fonts don't have yet. True: the fonts are to be made anew
    /// before the next frame. False where no font has them, which shows as U+FFFD, or where there are
    /// `mostLetters` already.
    [[nodiscard]] bool look(const ImDrawData& drawn);

private:
    friend void addFonts(float scale, const Catalogue* catalogue, const Letters& letters);

    bool told_ = false; ///< unknown letters are told apart; at first they all look like one
    std::set<ImWchar> asked_;
};

/// How many letters are loaded so: no more than an atlas has room for at this size of text.
[[nodiscard]] std::size_t mostLetters(float size);

/// Replaces Dear ImGui's fonts: one for text and one for code, each with the letters of the catalogue, which
/// may be nullptr, and with those that were asked for.
void addFonts(float scale, const Catalogue* catalogue, const Letters& letters);

/// Whether a font of this machine has the letters of a language.
[[nodiscard]] bool hasLettersOf(Language language);

/// The fixed-width font, for what is code.
[[nodiscard]] ImFont* codeFont();

} // namespace texplorer::ui
