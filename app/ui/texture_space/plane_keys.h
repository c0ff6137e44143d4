#pragma once

#include <array>

namespace texplorer::ui {

/// The keys of the texture space, active while the pointer is over it, and their effects: for lists of keys.
struct PlaneKeyRow {
    const char* keys;
    const char* effect;
};

inline constexpr std::array planeKeys{
    PlaneKeyRow{"G, R, S", "move, rotate, scale the selected vertices with the mouse"},
    PlaneKeyRow{"S, T (or X, Y) meanwhile", "one axis only, or both again"},
    PlaneKeyRow{"Enter or click, Escape", "confirm, cancel"},
    PlaneKeyRow{"Ctrl meanwhile", "snap to texels, quarters, or 0 and 1"},
    PlaneKeyRow{"Arrow keys, with Shift", "move the selected vertices by a texel, by 1/4"},
    PlaneKeyRow{"A", "select all vertices, or none"},
    PlaneKeyRow{"Shift + click, Shift + drag", "add one to the selection, select those in a box"},
    PlaneKeyRow{"Ctrl + C, Ctrl + V", "copy the coordinates as text, paste them"},
    PlaneKeyRow{"F, double click", "show the image and every vertex"},
};

} // namespace texplorer::ui
