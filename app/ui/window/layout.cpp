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
constexpr float leastBelow = 250;      // a card of Explain under its head
constexpr float mostBelow = 460;

int pixels(float unscaled, float scale) {
    return static_cast<int>(std::lround(unscaled * scale));
}

/// The widths of the side columns, unscaled: as the user dragged them, else by their shares of the window. In
/// a small one they give way to the view, down to what they need. One that isn't there has none.
struct Sides {
    float parameters;
    float details;
};
Sides sidesFor(float windowWidth, const Workspace& workspace, bool hasRight) {
    Sides sides{workspace.parameters ? std::clamp(0.24F * windowWidth, 316.0F, 420.0F) : 0,
                hasRight ? std::clamp(0.29F * windowWidth, 360.0F, 760.0F) : 0};
    const float view = std::min(comfortableView, windowWidth * 0.45F);
    const float available = windowWidth - 2 * seamWidth - view;
    const float share = std::min(1.0F, available / std::max(1.0F, sides.parameters + sides.details));
    const auto width = [share](float wanted, float least, float dragged) {
        return wanted == 0 ? 0 : dragged > 0 ? dragged : std::max(least, wanted * share);
    };
    return {width(sides.parameters, leastParameters, workspace.seams.parameters),
            width(sides.details, leastDetails, workspace.seams.details)};
}

/// The height of the dock below, of what lies between menu and status.
int belowFor(int inner, float scale, float dragged) {
    const auto height = static_cast<float>(inner);
    if (dragged > 0)
        return static_cast<int>(std::lround(height * std::clamp(dragged, 0.15F, 0.85F)));
    const float usual = std::clamp(0.37F * height / scale, leastBelow, mostBelow) * scale;
    return static_cast<int>(std::lround(std::min(usual, 0.45F * height)));
}

/// As measured; before that as English words need it.
int stripLines(int viewWidth, float scale, PaneGrid grid) {
    constexpr int most = 4;
    if (grid.stripLines > 0)
        return std::min(grid.stripLines, most);
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
        grid.compares
            ? atMost(stripHeight + stripLine * static_cast<float>(stripLines(view.width, s, grid) - 1), 4)
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

/// What is maximised takes the room of all but the parameters, the view that of these, too. What it hides
/// keeps the size of its picture: who explains a pixel of it goes on to do so.
void maximise(Layout& layout, Maximised what, const Rect& inner, PaneGrid grid) {
    Rect room = inner;
    if (what == Maximised::View) {
        layout.parameters = layout.leftSeam = {};
    } else {
        room.x = layout.leftSeam.right();
        room.width = inner.right() - room.x;
    }
    for (Rect* hidden : {&layout.view, &layout.texture, &layout.rightDock, &layout.belowDock,
                         &layout.rightSeam, &layout.middleSeam, &layout.belowSeam})
        *hidden = {};
    switch (what) {
    case Maximised::None:
        break;
    case Maximised::View:
        layout.view = room;
        layOutView(layout, grid);
        break;
    case Maximised::TextureSpace:
        layout.texture = room;
        break;
    case Maximised::Right:
        layout.rightDock = room;
        break;
    case Maximised::Below:
        layout.belowDock = room;
        break;
    }
}

/// Of the right column: texture space above, tabs below; either may have it alone.
void layOutRight(Layout& layout, const Rect& column, bool hasTabs, const Workspace& workspace, int seam) {
    if (!workspace.textureSpace || !hasTabs) {
        (hasTabs ? layout.rightDock : layout.texture) = column;
        return;
    }
    const float split = workspace.seams.split;
    // A lesson is read: it needs the room more than the texture does.
    const float usual = frontOf(workspace, Dock::Right) == Tab::Lesson ? 0.28F : 0.55F;
    const float share = split > 0 ? std::clamp(split, 0.15F, 0.85F) : usual;
    const int upper = static_cast<int>(std::lround(static_cast<float>(column.height - seam) * share));
    layout.texture = {column.x, column.y, column.width, upper};
    layout.middleSeam = {column.x, column.y + upper, column.width, seam};
    layout.rightDock = {column.x, column.y + upper + seam, column.width, column.height - seam - upper};
}

} // namespace

Layout layoutFor(int width, int height, float scale, const Workspace& workspace, PaneGrid grid) {
    Layout layout;
    layout.scale = std::clamp(scale, 0.5F, 8.0F);
    const float s = layout.scale;
    width = std::max(width, 1);
    height = std::max(height, 1);
    layout.window = {0, 0, width, height};

    const int bar = std::min(pixels(barHeight, s), height / 4);
    layout.menu = {0, 0, width, bar};
    layout.status = {0, height - bar, width, bar};
    const Rect inner{0, bar, width, height - 2 * bar};

    const bool tabsRight = frontOf(workspace, Dock::Right).has_value();
    const bool tabsBelow = frontOf(workspace, Dock::Below).has_value();
    const bool hasRight = workspace.textureSpace || tabsRight;
    const int seam = std::min(pixels(seamWidth, s), width / 32);
    const int leftSeam = workspace.parameters ? seam : 0;
    const int rightSeam = hasRight ? seam : 0;
    const int view = std::min(pixels(narrowestView, s), width / 3);
    const int least = std::min(pixels(narrowestColumn, s), width / 4);
    const int leastLeft = workspace.parameters ? least : 0;
    const int leastRight = hasRight ? least : 0;
    const Sides sides = sidesFor(static_cast<float>(width) / s, workspace, hasRight);
    int left = pixels(sides.parameters, s);
    int right = pixels(sides.details, s);
    // Both side columns give way, in proportion, until the view has its least width.
    const int available = width - leftSeam - rightSeam - view;
    if (left + right > available) {
        left = static_cast<int>(static_cast<long long>(left) * available / (left + right));
        right = hasRight ? available - left : 0;
    }
    left = std::clamp(left, leastLeft, std::max(leastLeft, available - leastRight));
    right = std::clamp(right, leastRight, std::max(leastRight, available - left));

    const int levelSeam = std::min(pixels(seamWidth, s), inner.height / 32);
    const int below = tabsBelow ? belowFor(inner.height, s, workspace.seams.below) : 0;
    const int belowSeam = tabsBelow ? levelSeam : 0;
    const int upper = inner.height - below - belowSeam;
    const int middle = left + leftSeam;

    if (workspace.parameters) {
        layout.parameters = {0, inner.y, left, inner.height};
        layout.leftSeam = {left, inner.y, leftSeam, inner.height};
    }
    layout.view = {middle, inner.y, width - middle - right - rightSeam, upper};
    layOutView(layout, grid);
    if (hasRight) {
        layout.rightSeam = {width - right - rightSeam, inner.y, rightSeam, upper};
        layOutRight(layout, {width - right, inner.y, right, upper}, tabsRight, workspace, levelSeam);
    }
    if (tabsBelow) {
        layout.belowSeam = {middle, inner.y + upper, width - middle, belowSeam};
        layout.belowDock = {middle, inner.y + upper + belowSeam, width - middle, below};
    }
    if (const Maximised what = maximisedOf(workspace); what != Maximised::None)
        maximise(layout, what, inner, grid);
    return layout;
}

} // namespace texplorer::ui
