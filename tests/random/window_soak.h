#pragma once

// Hands that know nothing, and a window of every shape.

#include "tests/random/soak.h"

namespace texplorer::random {

/// Each number is another scene in a window of another size, at which a mouse and a keyboard work at random.
/// Whatever they press, the window goes on, the scene stays one that a file can hold, every edit is recorded,
/// and Undo leads back to the beginning.
[[nodiscard]] Subject randomHands(unsigned seed);

/// How many layouts there are: all windows, scales, views, columns and details.
[[nodiscard]] int layoutCount();

/// Each number is another of them, and `layoutCount` in a row are all. Panels fill the window and don't
/// overlap, what is in them is no wider than they are, and of some the picture is looked at, too.
[[nodiscard]] Subject layouts(unsigned seed);

} // namespace texplorer::random
