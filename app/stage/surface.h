#pragma once

#include "app/view/size.h"

namespace texplorer::stage {

/// The target of a frame: the framebuffer that is bound while it is drawn.
struct Surface {
    view::Size size;     ///< in the units of the mouse, which are larger than pixels on some systems
    view::Size pixels;   ///< of the framebuffer
    float scale = 1;     ///< the monitor's content scale: the size of text in pixels
    bool visible = true; ///< false: minimised or hidden

    bool operator==(const Surface&) const = default;
};

} // namespace texplorer::stage
