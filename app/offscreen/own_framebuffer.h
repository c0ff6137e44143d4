#pragma once

#include "app/view/size.h"
#include "core/base/result.h"

namespace texplorer::offscreen {

/// Gives the current context, which has no surface, a framebuffer object in place of one, bound for drawing
/// and reading with its viewport: eight bits of each of RGBA, 24 of depth, bottom row first. It goes with its
/// context. A driver that knows no framebuffer objects is left as it is: who asks for its capabilities is
/// told. The error says which sizes there are, or what the driver can't do.
[[nodiscard]] Result<void> bindOwnFramebuffer(view::Size size);

} // namespace texplorer::offscreen
