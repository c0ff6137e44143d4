#pragma once

#include "app/ui/model/session.h"
#include "texplorer/scene/params/params.h"

#include <string>

namespace texplorer::ui {

/// The unit as the window shows it: "°", "°/s", "/s", "pixels". Empty: none.
[[nodiscard]] std::string unitText(const Range& range);

/// Dear ImGui's format of seconds in the window's language: "%.2f s".
[[nodiscard]] std::string secondsFormat();

/// The decimals of a number that is dragged in steps.
[[nodiscard]] int decimalsOf(const Range& range);

/// ImGui::DragFloat and DragInt within the limits, for numbers that are typed as people write them
/// (readNumber).
bool dragFloat(const char* id, float& value, float step, float min, float max, const char* format);
bool dragInt(const char* id, int& value, float step, int min, int max, const char* format = "%d");

/// A draggable number in the current item width, with the colour of its component on its left (-1: none).
/// `instead` is shown instead of the number, `letter` before it.
bool dragNumber(const char* id, float& value, const Range& range, int component,
                const char* instead = nullptr, const char* letter = nullptr);

/// A number with a slider from the range's minimum, which must be above 0, to `end`, on a logarithmic scale.
bool slideNumber(const char* id, float& value, const Range& range, float end);

/// Marks the last widget as a draggable number: by arrows at both ends if there is room, and by the mouse
/// pointer.
void markDraggable();

/// Ends an undo step when the last widget is released.
void sealAfterItem(const Session& session);

} // namespace texplorer::ui
