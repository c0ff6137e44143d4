#pragma once

#include <functional>
#include <span>

namespace texplorer::ui {

/// Something beside others, with the width that it needs.
struct FigureColumn {
    float width;
    std::function<void()> draw;
};

/// What is between two of them.
[[nodiscard]] float figureColumnGap();

/// Beside each other, and those that find no room below.
void drawFigureColumns(std::span<const FigureColumn> columns);

} // namespace texplorer::ui
