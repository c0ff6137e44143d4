#pragma once

// Random input to windows of every shape.

#include "tests/random/soak.h"

namespace texplorer::random {

/// Each number is another scene in a window of another size that gets random mouse and keyboard input. With
/// any input the window continues, the scene can be written to a file, every edit is recorded, and Undo leads
/// back to the beginning.
[[nodiscard]] Subject randomHands(unsigned seed);

/// The number of layouts: all combinations of windows, scales, views, columns and details.
[[nodiscard]] int layoutCount();

/// Each number is another layout; `layoutCount` in a row are all. Panels fill the window without overlapping,
/// their content is no wider than they are, and some pictures are checked, too.
[[nodiscard]] Subject layouts(unsigned seed);

} // namespace texplorer::random
