#pragma once

// Fits texts into a given width.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::sheet {

/// Measures the width of a line, in the unit of `room`.
using MeasureText = std::function<int(std::string_view)>;

/// Returns the text, or its beginning and end with "…" between them if it is too wide. If nothing fits, "…"
/// alone; empty only for an empty text. UTF-8 characters are never cut.
[[nodiscard]] std::string shortenedMiddle(std::string_view text, int room, const MeasureText& measure);

/// Breaks a text into at most `maxLines` lines, after a space or one of "_,;-/". Lines that do not fit, and
/// the rest of the text in the last line, are shortened in the middle.
[[nodiscard]] std::vector<std::string> labelLines(std::string_view text, int room, std::size_t maxLines,
                                                  const MeasureText& measure);

} // namespace texplorer::sheet
