#pragma once

namespace texplorer::ui {

/// Pixels of the framebuffer, origin at the top left.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    [[nodiscard]] int right() const { return x + width; }
    [[nodiscard]] int bottom() const { return y + height; }
    bool operator==(const Rect&) const = default;
};

/// What the user dragged the seams to; 0 leaves the choice to the layout.
struct Columns {
    float parameters = 0; ///< width of the left column, in unscaled pixels
    float details = 0;    ///< width of the right column, in unscaled pixels
    float split = 0;      ///< the share of the right column's height that the texture space takes, 0 to 1

    bool operator==(const Columns&) const = default;
};

/// How the view is divided among the pictures.
struct PaneGrid {
    int columns = 1;
    int rows = 1;
    bool compares = false; ///< there is a strip with numbers below them
};

/// Where everything is, as `layoutFor` has it. The panels fill the window without overlapping: menu on top,
/// status at the bottom, between them three columns with seams that one can drag.
struct Layout {
    float scale = 1;
    Rect window;
    Rect menu;
    Rect parameters;
    Rect view;   ///< the centre column: its tool row, the pictures and the hint line
    Rect canvas; ///< inside of `view`: all pictures
    Rect
        picture; ///< the first of them, pixel for pixel; all have this size. Where the panes are: see panes.h
    Rect strip;  ///< inside of `view`: what a comparison says, below the pictures; empty: there is none
    Rect texture; ///< right column, top
    Rect details; ///< right column, bottom
    Rect status;
    Rect leftSeam;
    Rect rightSeam;
    Rect middleSeam; ///< between `texture` and `details`
};

} // namespace texplorer::ui
