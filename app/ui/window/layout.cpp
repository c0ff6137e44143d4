#include "app/ui/window/layout.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace texplorer::ui {
namespace {

// Unscaled pixels.
struct Rows {
    float bar, toolRow, hint;
    float strip;     ///< of one line
    float stripLine; ///< for each further line
    float seam;
};
constexpr Rows smallRows{28, 36, 26, 32, 25, 5};
constexpr Rows largeRows{42, 44, 26, 46, 41, 14};
constexpr float maxTwoLineWidth = 575;   // a view up to this width has its strip in two lines
constexpr float maxThreeLineWidth = 320; // and up to this width in three
constexpr float paneGap = 2;
constexpr float minColumnWidth = 150;
constexpr float minViewWidth = 200;
constexpr float comfortableView = 420; // the width of the view while the columns have more than their minimum
constexpr float minParameters = 272;   // labels next to their controls
constexpr float minDetails = 326;      // all tabs in one row
constexpr float minBelow = 250;        // a card of Explain below its head
constexpr float maxBelow = 460;
constexpr float maxStackedWidth = 600; // of a phone held upright

int pixels(float unscaled, float scale) {
    return static_cast<int>(std::lround(unscaled * scale));
}

/// The widths of the side columns, unscaled: as dragged by the user, else by their fractions of the window.
/// In a small window they shrink to their minimum for the view. A missing column has the width 0.
struct Sides {
    float parameters;
    float details;
};
Sides sidesFor(float windowWidth, const Workspace& workspace, bool hasRight, float seam) {
    Sides sides{workspace.parameters ? std::clamp(0.24F * windowWidth, 316.0F, 420.0F) : 0,
                hasRight ? std::clamp(0.29F * windowWidth, 360.0F, 760.0F) : 0};
    const float view = std::min(comfortableView, windowWidth * 0.45F);
    const float available = windowWidth - 2 * seam - view;
    const float share = std::min(1.0F, available / std::max(1.0F, sides.parameters + sides.details));
    const auto width = [share](float wanted, float min, float dragged) {
        return wanted == 0 ? 0 : dragged > 0 ? dragged : std::max(min, wanted * share);
    };
    return {width(sides.parameters, minParameters, workspace.seams.parameters),
            width(sides.details, minDetails, workspace.seams.details)};
}

/// The height of the dock below, within the area between menu and status bar.
int belowFor(int inner, float scale, float dragged) {
    const auto height = static_cast<float>(inner);
    if (dragged > 0)
        return static_cast<int>(std::lround(height * std::clamp(dragged, 0.15F, 0.85F)));
    const float usual = std::clamp(0.37F * height / scale, minBelow, maxBelow) * scale;
    return static_cast<int>(std::lround(std::min(usual, 0.45F * height)));
}

/// As measured; before that, the number for English words.
int stripLines(int viewWidth, float scale, PaneGrid grid) {
    constexpr int max = 4;
    if (grid.stripLines > 0)
        return std::min(grid.stripLines, max);
    const float unscaled = static_cast<float>(viewWidth) / scale;
    return unscaled > maxTwoLineWidth ? 1 : unscaled > maxThreeLineWidth ? 2 : 3;
}

/// Places the view's parts from top to bottom.
void layOutView(Layout& layout, const Rows& rows, PaneGrid grid) {
    const Rect& view = layout.view;
    const float s = layout.scale;
    const auto atMost = [&](float unscaled, int share) {
        return std::min(pixels(unscaled, s), view.height / share);
    };
    const int toolRow = atMost(rows.toolRow, 4);
    const int hint = atMost(rows.hint, 4);
    const int strip =
        grid.compares
            ? atMost(rows.strip + rows.stripLine * static_cast<float>(stripLines(view.width, s, grid) - 1), 4)
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

/// A maximised panel takes all room except the parameters, the view takes that as well. A hidden view keeps
/// the size of its picture, so that the explanation of its pixel stays valid.
void maximise(Layout& layout, Maximised what, const Rect& inner, const Rows& rows, PaneGrid grid) {
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
    Rect Layout::*panel = what == Maximised::View           ? &Layout::view
                          : what == Maximised::TextureSpace ? &Layout::texture
                          : what == Maximised::Right        ? &Layout::rightDock
                                                            : &Layout::belowDock;
    layout.*panel = room;
    if (what == Maximised::View)
        layOutView(layout, rows, grid);
}

/// The right column: texture space above, tabs below; either may fill it.
void layOutRight(Layout& layout, const Rect& column, bool hasTabs, const Workspace& workspace, int seam) {
    if (!workspace.textureSpace || !hasTabs) {
        (hasTabs ? layout.rightDock : layout.texture) = column;
        return;
    }
    const float split = workspace.seams.split;
    // A lesson is text to read: it needs more room than the texture.
    const float usual = frontOf(workspace, Dock::Right) == Tab::Lesson ? 0.28F : 0.55F;
    const float share = split > 0 ? std::clamp(split, 0.15F, 0.85F) : usual;
    const int upper = static_cast<int>(std::lround(static_cast<float>(column.height - seam) * share));
    layout.texture = {column.x, column.y, column.width, upper};
    layout.middleSeam = {column.x, column.y + upper, column.width, seam};
    layout.rightDock = {column.x, column.y + upper + seam, column.width, column.height - seam - upper};
}

Rect Layout::*rectOf(Panel panel) {
    return panel == Panel::Parameters     ? &Layout::parameters
           : panel == Panel::TextureSpace ? &Layout::texture
           : panel == Panel::Right        ? &Layout::rightDock
                                          : &Layout::belowDock;
}

/// A narrow window has no room for columns.
void stack(Layout& layout, const Rect& inner, const Workspace& workspace, const Rows& rows, PaneGrid grid) {
    layout.view = inner;
    if (const std::optional<Panel> sheet = sheetOf(workspace)) {
        const int seam = std::min(pixels(rows.seam, layout.scale), inner.height / 32);
        const int bar = std::min(pixels(rows.toolRow, layout.scale), inner.height / 8);
        const float dragged = workspace.seams.below;
        const float share = dragged > 0 ? std::clamp(dragged, 0.15F, 0.85F) : 0.55F;
        const auto lower = static_cast<int>(std::lround(static_cast<float>(inner.height) * share));
        layout.view.height = std::max(1, inner.height - lower - seam);
        layout.belowSeam = {0, layout.view.bottom(), inner.width, seam};
        layout.sheets = {0, layout.belowSeam.bottom(), inner.width, bar};
        layout.*rectOf(*sheet) = {0, layout.sheets.bottom(), inner.width,
                                  inner.bottom() - layout.sheets.bottom()};
    }
    layOutView(layout, rows, grid);
}

} // namespace

Layout layoutFor(int width, int height, float scale, const Workspace& workspace, PaneGrid grid,
                 bool largeControls) {
    const Rows& rows = largeControls ? largeRows : smallRows;
    Layout layout;
    layout.scale = std::clamp(scale, 0.5F, 8.0F);
    const float s = layout.scale;
    width = std::max(width, 1);
    height = std::max(height, 1);
    layout.window = {0, 0, width, height};

    const int bar = std::min(pixels(rows.bar, s), height / 4);
    layout.menu = {0, 0, width, bar};
    layout.status = {0, height - bar, width, bar};
    const Rect inner{0, bar, width, height - 2 * bar};

    const Maximised maximised = maximisedOf(workspace);
    layout.isStacked = static_cast<float>(width) < maxStackedWidth * s && height > width;
    if (layout.isStacked) {
        stack(layout, inner, workspace, rows, grid);
        if (maximised != Maximised::None) {
            layout.parameters = {};
            layout.sheets =
                maximised == Maximised::View ? Rect{} : Rect{0, inner.y, width, layout.sheets.height};
            const int top = inner.y + layout.sheets.height;
            maximise(layout, maximised, {0, top, width, inner.bottom() - top}, rows, grid);
        }
        return layout;
    }

    const bool tabsRight = frontOf(workspace, Dock::Right).has_value();
    const bool tabsBelow = frontOf(workspace, Dock::Below).has_value();
    const bool hasRight = workspace.textureSpace || tabsRight;
    const int seam = std::min(pixels(rows.seam, s), width / 32);
    const int leftSeam = workspace.parameters ? seam : 0;
    const int rightSeam = hasRight ? seam : 0;
    const int view = std::min(pixels(minViewWidth, s), width / 3);
    const int min = std::min(pixels(minColumnWidth, s), width / 4);
    const int minLeft = workspace.parameters ? min : 0;
    const int minRight = hasRight ? min : 0;
    const Sides sides = sidesFor(static_cast<float>(width) / s, workspace, hasRight, rows.seam);
    int left = pixels(sides.parameters, s);
    int right = pixels(sides.details, s);
    // Both side columns shrink in proportion until the view has its minimum width.
    const int available = width - leftSeam - rightSeam - view;
    if (left + right > available) {
        left = static_cast<int>(static_cast<long long>(left) * available / (left + right));
        right = hasRight ? available - left : 0;
    }
    left = std::clamp(left, minLeft, std::max(minLeft, available - minRight));
    right = std::clamp(right, minRight, std::max(minRight, available - left));

    const int levelSeam = std::min(pixels(rows.seam, s), inner.height / 32);
    const int below = tabsBelow ? belowFor(inner.height, s, workspace.seams.below) : 0;
    const int belowSeam = tabsBelow ? levelSeam : 0;
    const int upper = inner.height - below - belowSeam;
    const int middle = left + leftSeam;

    if (workspace.parameters) {
        layout.parameters = {0, inner.y, left, inner.height};
        layout.leftSeam = {left, inner.y, leftSeam, inner.height};
    }
    layout.view = {middle, inner.y, width - middle - right - rightSeam, upper};
    layOutView(layout, rows, grid);
    if (hasRight) {
        layout.rightSeam = {width - right - rightSeam, inner.y, rightSeam, upper};
        layOutRight(layout, {width - right, inner.y, right, upper}, tabsRight, workspace, levelSeam);
    }
    if (tabsBelow) {
        layout.belowSeam = {middle, inner.y + upper, width - middle, belowSeam};
        layout.belowDock = {middle, inner.y + upper + belowSeam, width - middle, below};
    }
    if (maximised != Maximised::None)
        maximise(layout, maximised, inner, rows, grid);
    return layout;
}

} // namespace texplorer::ui
