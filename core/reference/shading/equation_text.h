#pragma once

#include "texplorer/base/sentence.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace texplorer::reference {

struct Operand {
    std::string_view symbol;
    float value;
};

/// Replaces every symbol of the equation by its value. Symbols are separate words: "Cp * (1 - Cs)".
[[nodiscard]] std::string inNumbers(std::string_view equation, std::initializer_list<Operand> operands);

/// "0.5 * 0.4 = 0.2", with the clamp to 0 … 1 if it changes the result.
[[nodiscard]] Sentence withResult(std::string_view numbers, float result);

/// Replaces the operators by those of handwriting: "Cp × (1 − Cs)".
[[nodiscard]] std::string withHandSigns(std::string equation);

/// "0.25", "1", "0.3333": at most four decimal places.
[[nodiscard]] std::string shortNumber(float value);

/// The same, with enough digits to distinguish it from `other`: 0.50001 does not read 0.5.
[[nodiscard]] std::string shortNumber(float value, float other);

} // namespace texplorer::reference
