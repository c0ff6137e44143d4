#pragma once

#include "texplorer/reference/explain/explanation_steps.h"

#include <imgui.h>

#include <optional>
#include <vector>

namespace texplorer::ui {

// Draws the lines of an explanation.

[[nodiscard]] ImU32 tintOf(reference::Ink ink);

/// Text after the previous item of the line. It wraps below its own beginning, or, if that would be narrow,
/// at the full width.
void hangingText(const Sentence& words, ImU32 tint);

/// A square of the colour, as opaque as a pixel is, with the next item next to it. Without a colour, does
/// nothing.
void swatch(const std::optional<glm::vec4>& color);

/// The width of the widest table among the rows, without sentences, which wrap.
[[nodiscard]] float rowsWidth(const std::vector<reference::StepRow>& rows);

/// Rows with the same number of cells share their columns. A table wider than the panel is drawn slightly
/// smaller; if that is not enough, each row has its cells below its label.
void drawRows(const std::vector<reference::StepRow>& rows);

} // namespace texplorer::ui
