#pragma once

#include "core/scene/params/params.h"

namespace texplorer::ui {

/// A number that one drags, in the current item width, with the colour of its component at its left (-1:
/// none). `instead` is shown in the place of the number.
bool dragNumber(const char* id, float& value, const Range& range, int component,
                const char* instead = nullptr);

/// The last widget is a number that one drags: arrows at both ends say so where there is room, and so does
/// the mouse.
void markDraggable();

} // namespace texplorer::ui
