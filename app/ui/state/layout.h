#pragma once

#include "app/ui/state/details_tabs.h"

namespace texplorer::ui {

/// Pixels of the framebuffer, origin at the top left.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    [[nodiscard]] int right() const { return x + width; }
    [[nodiscard]] int bottom() const { return y + height; }
    [[nodiscard]] bool isEmpty() const { return width <= 0 || height <= 0; }
    [[nodiscard]] bool contains(float atX, float atY) const {
        return atX >= static_cast<float>(x) && atX < static_cast<float>(right()) &&
               atY >= static_cast<float>(y) && atY < static_cast<float>(bottom());
    }
    bool operator==(const Rect&) const = default;
};

/// The division of the view among the pictures.
struct PaneGrid {
    int columns = 1;
    int rows = 1;
    bool compares = false; ///< a strip with numbers is below them
    int stripLines = 0;    ///< the measured number of its lines; 0: not measured yet
};

/// The rectangles of all parts, computed by `layoutFor`. The panels fill the window without overlapping: menu
/// at the top, status bar at the bottom, between them three columns with draggable seams; the middle and the
/// right one are above the dock below. A closed panel, or one hidden by something maximised, is empty, and so
/// is its seam. In a narrow window that is higher than wide, one panel is there, as a sheet below the view; a
/// bar between them chooses it.
struct Layout {
    float scale = 1;
    bool isStacked = false; ///< a narrow window
    Rect window;
    Rect menu;
    Rect parameters;
    Rect view;      ///< the centre column: its tool row, the pictures and the hint line
    Rect canvas;    ///< inside of `view`: all pictures
    Rect picture;   ///< the first one, pixel by pixel; all have this size, visible or not: see panes.h
    Rect strip;     ///< inside of `view`: the results of a comparison, below the pictures; empty: none
    Rect texture;   ///< right column, top
    Rect rightDock; ///< right column, bottom
    Rect belowDock; ///< below the view and the right column
    Rect sheets;    ///< the bar above a sheet
    Rect status;
    Rect leftSeam;
    Rect rightSeam;
    Rect middleSeam; ///< between `texture` and `rightDock`
    Rect belowSeam;  ///< above `belowDock`

    [[nodiscard]] const Rect& of(Dock dock) const { return dock == Dock::Right ? rightDock : belowDock; }
};

/// Of a picture: width by height.
[[nodiscard]] inline float aspectOf(const Layout& layout) {
    return static_cast<float>(layout.picture.width) /
           static_cast<float>(layout.picture.height > 1 ? layout.picture.height : 1);
}

} // namespace texplorer::ui
