#pragma once

#include <functional>
#include <span>

namespace texplorer::ui {

/// A column of a figure, with the width that it needs.
struct FigureColumn {
    float width;
    std::function<void()> draw;
};

/// The space between two columns.
[[nodiscard]] float figureColumnGap();

/// Draws the columns next to each other; those that do not fit go below.
void drawFigureColumns(std::span<const FigureColumn> columns);

} // namespace texplorer::ui
