#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"

#include <array>

namespace texplorer::ui {

inline constexpr std::array textSizes{75, 90, 100, 110, 125, 150, 175, 200, 225, 250}; // percent
static_assert(textSizes.front() == Settings::minText && textSizes.back() == Settings::maxText);

/// Goes one step up or down in the list of text sizes.
void changeTextSize(Session& session, int steps);

/// Ctrl and the wheel do the same, unless they zoom the item under the pointer. `turned`: the rest of a step,
/// from frame to frame.
void resizeTextByWheel(const Session& session, float& turned, const Layout& layout);

} // namespace texplorer::ui
