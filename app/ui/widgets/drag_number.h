#pragma once

#include "core/scene/params/params.h"

namespace texplorer::ui {

/// A number that one drags, in the current item width, with the colour of its component at its left (-1:
/// none). `instead` is shown in the place of the number, `letter` before it.
bool dragNumber(const char* id, float& value, const Range& range, int component,
                const char* instead = nullptr, const char* letter = nullptr);

/// A number with a slider from the range's least one, which is above 0, to `end`: what doubles is as far
/// apart everywhere.
bool slideNumber(const char* id, float& value, const Range& range, float end);

/// The last widget is a number that one drags: arrows at both ends say so where there is room, and so does
/// the mouse.
void markDraggable();

} // namespace texplorer::ui
