#pragma once

#include "texplorer/reference/explain/explanation_steps.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// Its title, and what became of it unless it was drawn.
[[nodiscard]] std::string titleOf(const reference::FragmentSteps& fragment);

/// Every fragment of a pixel with its steps one below the other, for a narrow panel: first the visible one,
/// then the others in drawing order. Differences of the visible one from `other` are marked; nullptr: none
/// are.
void drawFragmentList(const reference::Explanation& explanation,
                      const std::vector<reference::FragmentSteps>& fragments,
                      const reference::FragmentSteps* other = nullptr);

} // namespace texplorer::ui
