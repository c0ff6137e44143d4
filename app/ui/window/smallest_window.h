#pragma once

#include "app/view/frame.h"

namespace texplorer::ui {

/// The panels don't fit into less.
inline constexpr view::Size smallestWindow{320, 200};

} // namespace texplorer::ui
