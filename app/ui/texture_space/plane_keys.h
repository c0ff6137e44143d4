#pragma once

#include "texplorer/base/translatable.h"

#include <array>

namespace texplorer::ui {

/// The keys of the texture space, active while the pointer is over it, and their effects: for lists of keys.
struct PlaneKeyRow {
    const char* keys;
    const char* effect;
};

inline constexpr std::array planeKeys{
    PlaneKeyRow{"G, R, S", N_("move, rotate, scale the selected vertices with the mouse")},
    PlaneKeyRow{N_("S, T (or X, Y) meanwhile"), N_("one axis only, or both again")},
    PlaneKeyRow{N_("Enter or click, Escape"), N_("confirm, cancel")},
    PlaneKeyRow{N_("Ctrl meanwhile"), N_("snap to texels, quarters, or 0 and 1")},
    PlaneKeyRow{N_("Arrow keys, with Shift"), N_("move the selected vertices by a texel, by 1/4")},
    PlaneKeyRow{"A", N_("select all vertices, or none")},
    PlaneKeyRow{N_("Shift + click, Shift + drag"), N_("add one to the selection, select those in a box")},
    PlaneKeyRow{N_("Ctrl + C, Ctrl + V"), N_("copy the coordinates as text, paste them")},
    PlaneKeyRow{N_("F, double click"), N_("show the image and every vertex")},
};

} // namespace texplorer::ui
