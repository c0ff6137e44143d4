#pragma once

#include "app/view/size.h"

namespace texplorer::stage {

/// Where a frame goes: the framebuffer that is bound while it is drawn.
struct Surface {
    view::Size size;     ///< in the units of the mouse, which on some systems are larger than pixels
    view::Size pixels;   ///< of the framebuffer
    float scale = 1;     ///< of the monitor's content: how large text should be, in pixels
    bool visible = true; ///< false: minimised, nobody sees it

    bool operator==(const Surface&) const = default;
};

} // namespace texplorer::stage
