#include "app/ui/layout.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

// Unscaled pixels.
constexpr float barHeight = 28;
constexpr float toolRowHeight = 36;
constexpr float hintHeight = 26;
constexpr float seamWidth = 5;
constexpr float narrowestColumn = 150;
constexpr float narrowestView = 160;

int pixels(float unscaled, float scale) {
    return static_cast<int>(std::lround(unscaled * scale));
}

float columnWidth(float wanted, float share, float least, float most, float windowWidth) {
    return wanted > 0 ? wanted : std::clamp(share * windowWidth, least, most);
}

} // namespace

Layout layoutFor(int width, int height, float scale, const Columns& columns) {
    Layout layout;
    layout.scale = std::clamp(scale, 0.5F, 8.0F);
    const float s = layout.scale;
    width = std::max(width, 1);
    height = std::max(height, 1);
    layout.window = {0, 0, width, height};

    const int bar = std::min(pixels(barHeight, s), height / 4);
    layout.menu = {0, 0, width, bar};
    layout.status = {0, height - bar, width, bar};
    const int top = bar;
    const int inner = height - 2 * bar;

    const float unscaledWidth = static_cast<float>(width) / s;
    const int seam = std::min(pixels(seamWidth, s), width / 32);
    const int view = std::min(pixels(narrowestView, s), width / 3);
    const int least = std::min(pixels(narrowestColumn, s), width / 4);
    int left = pixels(columnWidth(columns.parameters, 0.24F, 316, 420, unscaledWidth), s);
    int right = pixels(columnWidth(columns.details, 0.29F, 360, 760, unscaledWidth), s);
    // Both side columns give way, in proportion, until the view has its least width.
    const int available = width - 2 * seam - view;
    if (left + right > available) {
        left = static_cast<int>(static_cast<long long>(left) * available / (left + right));
        right = available - left;
    }
    left = std::clamp(left, least, std::max(least, available - least));
    right = std::clamp(right, least, std::max(least, available - left));

    layout.parameters = {0, top, left, inner};
    layout.leftSeam = {left, top, seam, inner};
    layout.rightSeam = {width - right - seam, top, seam, inner};
    layout.view = {left + seam, top, width - left - right - 2 * seam, inner};

    const int toolRow = std::min(pixels(toolRowHeight, s), inner / 4);
    const int hint = std::min(pixels(hintHeight, s), inner / 4);
    layout.picture = {layout.view.x, top + toolRow, layout.view.width, std::max(1, inner - toolRow - hint)};

    const float share = columns.split > 0 ? std::clamp(columns.split, 0.15F, 0.85F) : 0.55F;
    const int upper = static_cast<int>(std::lround(static_cast<float>(inner - seam) * share));
    layout.texture = {width - right, top, right, upper};
    layout.middleSeam = {width - right, top + upper, right, seam};
    layout.details = {width - right, top + upper + seam, right, inner - seam - upper};
    return layout;
}

} // namespace texplorer::ui
