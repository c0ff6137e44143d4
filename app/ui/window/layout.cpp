#include "app/ui/window/layout.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

// Unscaled pixels.
constexpr float barHeight = 28;
constexpr float toolRowHeight = 36;
constexpr float hintHeight = 26;
constexpr float stripHeight = 32;      // of one line
constexpr float stripLine = 25;        // of each line more
constexpr float widestNarrow = 575;    // a view up to here has its strip in two lines
constexpr float widestNarrowest = 320; // and up to here in three
constexpr float paneGap = 2;
constexpr float seamWidth = 5;
constexpr float narrowestColumn = 150;
constexpr float narrowestView = 200;
constexpr float comfortableView = 420; // what the columns leave it while they have more than their least
constexpr float leastParameters = 272; // labels beside their controls
constexpr float leastDetails = 326;    // all tabs side by side

int pixels(float unscaled, float scale) {
    return static_cast<int>(std::lround(unscaled * scale));
}

/// The widths of the side columns, unscaled: as the user dragged them, else by their shares of the window. In
/// a small one they give way to the view, down to what they need.
struct Sides {
    float parameters;
    float details;
};
Sides sidesFor(float windowWidth, const Columns& columns) {
    Sides sides{std::clamp(0.24F * windowWidth, 316.0F, 420.0F),
                std::clamp(0.29F * windowWidth, 360.0F, 760.0F)};
    const float view = std::min(comfortableView, windowWidth * 0.45F);
    const float available = windowWidth - 2 * seamWidth - view;
    const float share = std::min(1.0F, available / (sides.parameters + sides.details));
    sides = {std::max(leastParameters, sides.parameters * share),
             std::max(leastDetails, sides.details * share)};
    return {columns.parameters > 0 ? columns.parameters : sides.parameters,
            columns.details > 0 ? columns.details : sides.details};
}

int stripLines(int viewWidth, float scale) {
    const float unscaled = static_cast<float>(viewWidth) / scale;
    return unscaled > widestNarrow ? 1 : unscaled > widestNarrowest ? 2 : 3;
}

/// The view's parts, from top to bottom.
void layOutView(Layout& layout, PaneGrid grid) {
    const Rect& view = layout.view;
    const float s = layout.scale;
    const auto atMost = [&](float unscaled, int share) {
        return std::min(pixels(unscaled, s), view.height / share);
    };
    const int toolRow = atMost(toolRowHeight, 4);
    const int hint = atMost(hintHeight, 4);
    const int strip =
        grid.compares ? atMost(stripHeight + stripLine * static_cast<float>(stripLines(view.width, s) - 1), 4)
                      : 0;
    layout.canvas = {view.x, view.y + toolRow, view.width, std::max(1, view.height - toolRow - hint - strip)};
    layout.strip = {view.x, layout.canvas.bottom(), view.width, strip};
    const int gap = pixels(paneGap, s);
    const auto share = [gap](int length, int count) {
        return std::max(1, (length - (count - 1) * gap) / count);
    };
    layout.picture = {layout.canvas.x, layout.canvas.y, share(layout.canvas.width, grid.columns),
                      share(layout.canvas.height, grid.rows)};
}

} // namespace

Layout layoutFor(int width, int height, float scale, const Columns& columns, PaneGrid grid) {
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
    const Sides sides = sidesFor(unscaledWidth, columns);
    int left = pixels(sides.parameters, s);
    int right = pixels(sides.details, s);
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

    layOutView(layout, grid);

    const float share = columns.split > 0 ? std::clamp(columns.split, 0.15F, 0.85F) : 0.55F;
    const int upper = static_cast<int>(std::lround(static_cast<float>(inner - seam) * share));
    layout.texture = {width - right, top, right, upper};
    layout.middleSeam = {width - right, top + upper, right, seam};
    layout.details = {width - right, top + upper + seam, right, inner - seam - upper};
    return layout;
}

} // namespace texplorer::ui
