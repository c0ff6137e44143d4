#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// The width of a text; the widths of adjacent texts must add up.
using TextMeasure = std::function<float(std::string_view)>;

/// Breaks a text (UTF-8) into lines for a column of width `room`, as parts of it without the blanks at their
/// ends. Breaks after "\n", at blanks, and between ideographs by the rules of Chinese typesetting: no line
/// begins with a closing mark, ，。」”%, or with a dash, and none ends with an opening one, （「“. A word
/// that is wider than the column is broken.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text, float room,
                                                    const TextMeasure& widthOf);

/// The width of the narrowest column in which no word of a text is broken.
[[nodiscard]] float widestPiece(std::string_view text, const TextMeasure& widthOf);

} // namespace texplorer::ui
