#pragma once

#include <optional>
#include <string_view>

namespace texplorer::ui {

/// A number as people write it: "1.5" and "1,5"; with both signs, as in "1,234.5" and "1.234,5", the last one
/// is the decimal point. A sign that occurs several times separates thousands, as in "1,234,567". Nothing: it
/// is no number, or its groups are not of three digits.
[[nodiscard]] std::optional<float> readNumber(std::string_view text);

/// While a number is typed into the widget of Dear ImGui with this ID, draws its field in place of the
/// widget: Dear ImGui itself reads no commas. What is no number changes nothing. Returns whether `value`
/// changed; nothing: no number is typed.
std::optional<bool> typedNumber(const char* id, float& value, float min, float max, const char* format);

} // namespace texplorer::ui
