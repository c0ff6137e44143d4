#include "app/ui/timeline/time_scale.h"

#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace texplorer::ui {
namespace {

constexpr float hundredth = 0.01F;

/// The smallest of 1, 2 and 5 times a power of ten that is not below.
float roundUp(float value) {
    const float power = std::pow(10.0F, std::floor(std::log10(value)));
    for (const float factor : {1.0F, 2.0F, 5.0F}) {
        if (factor * power >= value * 0.999F)
            return factor * power;
    }
    return 10 * power;
}

} // namespace

float TimeScale::timeAt(float x) const {
    return std::clamp(secondsOf(x - left), 0.0F, seconds);
}

float secondsFor(double length, double present) {
    constexpr double min = 2;
    constexpr double room = 1.25;
    const double needed = std::max({min, length * room, present});
    return static_cast<float>(std::ceil(needed));
}

float snapped(float time, float grid) {
    constexpr double perSecond = 100; // written with hundredths: the nearest float
    const double step = grid > 0 ? static_cast<double>(grid) : 1 / perSecond;
    const double at = std::round(static_cast<double>(time) / step) * step;
    return static_cast<float>(std::round(at * perSecond) / perSecond);
}

float markStep(const TimeScale& scale, float room) {
    return std::max(0.1F, roundUp(std::max(scale.secondsOf(room), hundredth)));
}

void drawRuler(ImDrawList& draw, const TimeScale& scale, float top, float height) {
    const float em = ImGui::GetFontSize();
    const float step = markStep(scale, em * 4.5F);
    const float size = em * 0.85F;
    const auto marks = static_cast<int>(std::floor(scale.seconds / step + 0.001F));
    for (int i = 0; i <= marks; ++i) {
        const float time = static_cast<float>(i) * step;
        const float x = std::floor(scale.xOf(static_cast<double>(time))) + 0.5F;
        draw.AddLine({x, top + height * 0.65F}, {x, top + height}, color::dim);
        const std::string words = fmt::format("{:g} s", std::round(time * 10) / 10);
        const float width = ImGui::GetFont()->CalcTextSizeA(size, 1e6F, 0, words.c_str()).x;
        const float from = std::clamp(x - width / 2, scale.left, scale.left + scale.width - width);
        draw.AddText(ImGui::GetFont(), size, {from, top}, color::dim, words.c_str());
    }
}

} // namespace texplorer::ui
