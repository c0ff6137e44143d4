#include "app/ui/texture_space/plane_keys.h"

#include <array>

namespace texplorer::ui {
namespace {

constexpr std::array planeKeyRows{
    PlaneKeyRow{"G, R, S", "move, rotate, scale the chosen vertices with the mouse"},
    PlaneKeyRow{"S, T meanwhile, or X, Y", "one axis alone, or both again"},
    PlaneKeyRow{"Enter or click, Escape", "keep what was moved, take it back"},
    PlaneKeyRow{"Ctrl meanwhile", "come to rest on texels, quarters, or 0 and 1"},
    PlaneKeyRow{"Arrow keys, with Shift", "move the chosen vertices by a texel, by 1/4"},
    PlaneKeyRow{"A", "choose all vertices, or none"},
    PlaneKeyRow{"Shift + click, Shift + drag", "choose one more, choose those in a box"},
    PlaneKeyRow{"Ctrl + C, Ctrl + V", "copy the coordinates as text, paste them"},
    PlaneKeyRow{"F, double click", "show the image and every vertex"},
};

} // namespace

std::span<const PlaneKeyRow> planeKeys() {
    return planeKeyRows;
}

} // namespace texplorer::ui
