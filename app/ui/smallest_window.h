#pragma once

#include "app/render/frame.h"

namespace texplorer::ui {

/// The panels don't fit into less.
inline constexpr render::Size smallestWindow{320, 200};

} // namespace texplorer::ui
