#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// How wide a piece of text is; that of two pieces side by side is the sum of theirs.
using TextMeasure = std::function<float(std::string_view)>;

/// The lines of a text (UTF-8) in a column `room` wide, as parts of it without the blanks at their ends.
/// Broken after "\n", at blanks, and between ideographs as Chinese typesetting has it: no line begins with a
/// mark that closes or ends something, ，。」”%, nor with a dash, and none ends with one that opens
/// something, （「“. A word that is wider than the column is broken where it must be.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text, float room,
                                                    const TextMeasure& widthOf);

} // namespace texplorer::ui
