#pragma once

#include "core/reference/explain/explanation_steps.h"

#include <vector>

namespace texplorer::ui {

/// Every fragment of a pixel with its steps below each other, for a panel that is narrow: first the one that
/// is seen, then the rest in the order of drawing. What the one that is seen has otherwise than `other` is
/// marked; nullptr: nothing is.
void drawFragmentList(const reference::Explanation& explanation,
                      const std::vector<reference::FragmentSteps>& fragments,
                      const reference::FragmentSteps* other = nullptr);

} // namespace texplorer::ui
