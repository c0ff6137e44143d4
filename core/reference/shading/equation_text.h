#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace texplorer::reference {

struct Operand {
    std::string_view symbol;
    float value;
};

/// The equation with every symbol replaced by its value. Symbols stand in words of their own: "Cp * (1 -
/// Cs)".
[[nodiscard]] std::string inNumbers(std::string_view equation, std::initializer_list<Operand> operands);

/// "0.5 * 0.4 = 0.2", with the clamp to 0 … 1 where it takes effect.
[[nodiscard]] std::string withResult(std::string_view numbers, float result);

/// With the signs that one writes by hand: "Cp × (1 − Cs)".
[[nodiscard]] std::string withHandSigns(std::string equation);

/// "0.25", "1", "0.3333": at most four digits after the point.
[[nodiscard]] std::string shortNumber(float value);

/// The same, with as many digits as tell it from `other`: 0.50001 isn't 0.5.
[[nodiscard]] std::string shortNumber(float value, float other);

} // namespace texplorer::reference
