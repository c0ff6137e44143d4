#pragma once

#include <chrono>
#include <functional>

namespace texplorer {

/// Seconds on a clock that only goes forwards. Whoever waits for a time is lent one, so that a test can say
/// what time it is.
using Clock = std::function<double()>;

/// The system's.
[[nodiscard]] inline double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace texplorer
