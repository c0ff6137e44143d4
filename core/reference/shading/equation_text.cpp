#include "texplorer/reference/shading/equation_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace texplorer::reference {

std::string shortNumber(float value) {
    std::string number = fmt::format("{:.4f}", value);
    if (number.find('.') == std::string::npos) // "inf", "nan"
        return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.')
        number.pop_back();
    return number == "-0" ? "0" : number;
}

std::string shortNumber(float value, float other) {
    const std::string number = shortNumber(value);
    return value != other && number == shortNumber(other) ? fmt::format("{}", value) : number;
}

std::string withHandSigns(std::string equation) {
    constexpr std::array<std::array<std::string_view, 2>, 2> signs{{{" * ", " × "}, {" - ", " − "}}};
    for (const auto& [from, to] : signs) {
        for (std::size_t at = equation.find(from); at != std::string::npos; at = equation.find(from, at))
            equation.replace(at, from.size(), to);
    }
    return equation;
}

Sentence withResult(std::string_view numbers, float result) {
    const float clamped = std::clamp(result, 0.0F, 1.0F);
    const std::string equation = fmt::format("{} = {}", numbers, shortNumber(result, clamped));
    return clamped == result
               ? Sentence(ProperName{equation})
               : Sentence("{0}, clamped to {1}", ProperName{equation}, ProperName{shortNumber(clamped)});
}

std::string inNumbers(std::string_view equation, std::initializer_list<Operand> operands) {
    const auto isWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    std::string text;
    for (std::size_t at = 0; at < equation.size();) {
        std::size_t end = at;
        while (end < equation.size() && isWord(equation[end]))
            ++end;
        if (end == at) {
            text += equation[at++];
            continue;
        }
        const std::string_view word = equation.substr(at, end - at);
        at = end;
        const Operand* found = nullptr;
        for (const Operand& each : operands) {
            if (each.symbol == word)
                found = &each;
        }
        text += found ? shortNumber(found->value) : std::string(word);
    }
    return text;
}

} // namespace texplorer::reference
