#pragma once

namespace texplorer::bench {

/// Whether benchmarks only check that they work (--once): those that take seconds do less. Set before they
/// run.
inline bool onlyOnce = false;

} // namespace texplorer::bench
