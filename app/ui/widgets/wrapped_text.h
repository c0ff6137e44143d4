#pragma once

#include "app/ui/widgets/palette.h"
#include "texplorer/base/sentence.h"

#include <imgui.h>

#include <string>
#include <string_view>

namespace texplorer::ui {

/// Untranslated text: names of files, models and lessons, and texts that are translated already. If Dear
/// ImGui wraps text (PushTextWrapPos), lines are broken by `linesOf`.
void plainText(std::string_view words);
void plainText(std::string_view words, ImU32 ink);
void dimPlainText(std::string_view words);

/// The same, wrapped at the right edge unless another position is set.
void plainWrappedText(std::string_view words);
void plainWrappedText(std::string_view words, ImU32 ink);

/// Texts in English, which are translated.
void text(const Sentence& words);
void text(const Sentence& words, ImU32 ink);
void dimText(const Sentence& words);
/// A label next to a control, and as high.
void labelText(const Sentence& words, ImU32 ink = color::text);
/// Wraps at the available width.
void wrappedText(const Sentence& words);
void wrappedText(const Sentence& words, ImU32 ink);
void dimWrappedText(const Sentence& words);

/// A small caption above a group, with a line to its right.
void caption(const Sentence& words);

/// Such a text wrapped at a width in the current font, with newlines between its lines; and its size.
[[nodiscard]] std::string wrappedLines(std::string_view words, float room);
[[nodiscard]] ImVec2 wrappedSize(std::string_view words, float room);

/// Call it if a font's letters have changed: the widths of texts may have changed as well.
void forgetWrappedTexts();

/// At most so many bytes of a longer text (UTF-8): whole letters.
[[nodiscard]] std::string_view beginningOf(std::string_view text, std::size_t bytes);

/// A text without unreadably long parts, because a draw list of Dear ImGui has room for 16,000 letters: the
/// middle of a word is left out from 160 bytes on, the end of the text from 4,000.
[[nodiscard]] std::string readablePart(std::string_view words);

} // namespace texplorer::ui
