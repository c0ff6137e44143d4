#pragma once

#include "app/view/size.h"

namespace texplorer::ui {

/// The panels do not fit into a smaller window.
inline constexpr view::Size minWindowSize{320, 200};

} // namespace texplorer::ui
