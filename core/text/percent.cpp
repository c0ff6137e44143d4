#include "texplorer/text/percent.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer {
namespace {

constexpr int digits = 3;
constexpr int maxDecimals = 12;

std::string withDecimals(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos)
        text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.'))
        text.pop_back();
    return text;
}

} // namespace

std::string percentText(double share) {
    const double value = share * 100;
    const int before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
    int decimals = std::clamp(digits - before, 0, maxDecimals);
    std::string text = withDecimals(value, decimals);
    while (value < 100 && text == "100" && decimals < maxDecimals)
        text = withDecimals(value, ++decimals);
    return text + " %";
}

} // namespace texplorer
