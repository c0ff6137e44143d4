#pragma once

namespace texplorer {

/// An advisory lock on an open file, held until the last descriptor of this opening is closed: by the end of
/// the process at the latest. Waits for nobody. 0, or an errno: EWOULDBLOCK where somebody else holds it.
[[nodiscard]] int lockFile(int file);

} // namespace texplorer
