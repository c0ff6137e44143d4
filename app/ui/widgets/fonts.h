#pragma once

#include "app/ui/language/catalogue.h"

#include <imgui.h>

#include <cstddef>
#include <filesystem>
#include <set>

namespace texplorer::ui {

/// Additional letters of the window's fonts, beyond those of its language: for names from outside in any
/// script. Dear ImGui has only the letters in its font atlas, so each letter is loaded after it was first
/// drawn; a name is correct two frames later.
class Letters {
public:
    /// Looks for drawn letters that the fonts do not have yet. True: build the fonts again before the next
    /// frame. False if no font has them, which shows as U+FFFD, or if there are `maxLetters` already.
    [[nodiscard]] bool look(const ImDrawData& drawn);
    /// Whether some of them are only in a font of Chinese letters, as ideographs are.
    [[nodiscard]] bool needChineseFont() const;

private:
    friend void addFonts(float scale, const Catalogue* catalogue, const Letters& letters);

    bool told_ = false; ///< unknown letters are distinguished; initially they all look the same
    std::set<ImWchar> asked_;
};

/// The maximum number of such letters: as many as fit into an atlas at this size of text.
[[nodiscard]] std::size_t maxLetters(float size);

/// Replaces Dear ImGui's fonts: one for text and one for code, each with the letters of the catalogue, which
/// may be nullptr, and with the additional ones.
void addFonts(float scale, const Catalogue* catalogue, const Letters& letters);

/// Whether a file can be read and is a TrueType or OpenType font, or a collection of them, with no table
/// beyond its end. Dear ImGui aborts for any other file. Depends only on the file.
[[nodiscard]] bool isFontFile(const std::filesystem::path& file);

/// Whether a font on this machine has the letters of a language.
[[nodiscard]] bool hasLettersOf(Language language);

/// The monospaced font for code.
[[nodiscard]] ImFont* codeFont();

} // namespace texplorer::ui
