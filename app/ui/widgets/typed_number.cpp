#include "app/ui/widgets/typed_number.h"

#include <imgui_internal.h> // whether a number is being typed

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

namespace texplorer::ui {
namespace {

/// The value of the field before it was typed.
struct Before {
    ImGuiID field = 0;
    float value = 0;
};

/// Whether a sign separates groups of three digits in the whole part of a number.
bool separatesThousands(std::string_view whole, char sign) {
    for (std::size_t at = whole.find(sign); at != std::string_view::npos; at = whole.find(sign, at + 1)) {
        const std::size_t next = std::min(whole.find(sign, at + 1), whole.size());
        if (at == 0 || next - at != 4)
            return false;
    }
    return true;
}

} // namespace

std::optional<float> readNumber(std::string_view text) {
    const std::size_t last = text.find_last_of(".,");
    const char sign = last == std::string_view::npos ? '.' : text[last];
    const bool hasPoint = std::ranges::count(text, sign) == 1;
    const std::size_t end = hasPoint ? last : std::min(text.find_first_of("eE"), text.size());
    const std::string_view rest = text.substr(hasPoint ? end + 1 : end);
    const std::size_t start = text.starts_with('+') ? 1 : 0;
    std::string number(text.substr(start, end - start));
    const char thousands = hasPoint == (sign == '.') ? ',' : '.';
    if (!separatesThousands(number, thousands))
        return std::nullopt;
    std::erase(number, thousands);
    number.append(hasPoint ? "." : "").append(rest);
    char* stop = nullptr;
    const float value = std::strtof(number.c_str(), &stop); // infinite if it is too large
    const bool isNumber = !number.empty() && *stop == '\0' && !std::isnan(value);
    return isNumber ? std::optional(value) : std::nullopt;
}

std::optional<bool> typedNumber(const char* id, float& value, float min, float max, const char* format) {
    static Before before; // only one number is typed at a time
    const ImGuiID field = ImGui::GetID(id);
    if (!ImGui::TempInputIsActive(field)) {
        if (before.field == field)
            before = {};
        return std::nullopt;
    }
    if (before.field != field)
        before = {field, value};
    std::array<char, 32> shape{};
    std::array<char, 64> text{};
    format = ImParseFormatTrimDecorations(format, shape.data(), shape.size());
    ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), ImGuiDataType_Float, &value,
                                format);
    const auto isOfNumber = [](ImGuiInputTextCallbackData* data) {
        return data->EventChar < 128 && std::strchr("0123456789.,+-eE", data->EventChar) ? 0 : 1;
    };
    const float was = value;
    if (ImGui::InputText(id, text.data(), text.size(), ImGuiInputTextFlags_CallbackCharFilter, isOfNumber))
        value = std::clamp(readNumber(text.data()).value_or(before.value), min, max);
    return value != was;
}

} // namespace texplorer::ui
