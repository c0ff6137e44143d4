#pragma once

#include "core/reference/explain/explanation_steps.h"

#include <imgui.h>

#include <string>
#include <vector>

namespace texplorer::ui {

// How the lines of an explanation are drawn, wherever they stand.

[[nodiscard]] ImU32 tintOf(reference::Ink ink);

void inkText(const std::string& words, ImU32 tint);

/// Text beside what stands in the line already: what has no room goes on below its beginning, or, where that
/// would be narrow, on lines of its own.
void hangingText(const std::string& words, ImU32 tint);

/// A square of the colour, as opaque as a pixel is.
void swatch(glm::vec4 color);

/// The width of the widest table among the rows; sentences are wrapped.
[[nodiscard]] float rowsWidth(const std::vector<reference::StepRow>& rows);

/// Rows with the same number of cells share their columns. What is wider than the panel is somewhat smaller,
/// and where that isn't enough each row has its cells below its label.
void drawRows(const std::vector<reference::StepRow>& rows);

} // namespace texplorer::ui
