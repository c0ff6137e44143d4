#pragma once

namespace texplorer {

/// Takes an advisory lock on an open file. The lock is held until the last descriptor of this open file is
/// closed, at the latest when the process ends. Does not block. Returns 0 or an errno: EWOULDBLOCK if another
/// process or descriptor holds it.
[[nodiscard]] int lockFile(int file);

} // namespace texplorer
