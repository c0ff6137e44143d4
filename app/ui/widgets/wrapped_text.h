#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace texplorer::ui {

/// Words as they are, in the language that they are in: names of files, models and lessons, and what is
/// translated already. Where Dear ImGui wraps text (PushTextWrapPos), lines end as `linesOf` has it.
void plainText(std::string_view words);
void dimPlainText(std::string_view words);

/// The same, wrapped at the right edge where no other place is set.
void plainWrappedText(std::string_view words);

/// Such a text in a column so wide, in the font that is in use, with a line end after each line but the last;
/// and how large it is.
[[nodiscard]] std::string wrappedLines(std::string_view words, float room);
[[nodiscard]] ImVec2 wrappedSize(std::string_view words, float room);

/// Call it where a font's letters have changed: the widths of its texts may have, too.
void forgetWrappedTexts();

/// A text with what one can't read left out, since a draw list of Dear ImGui's has room for 16,000 letters:
/// of a word the middle, from 160 bytes on; of the whole the end, from 4,000.
[[nodiscard]] std::string readablePart(std::string_view words);

} // namespace texplorer::ui
