#pragma once

#include <chrono>
#include <functional>

namespace texplorer {

/// Returns the seconds of a clock that never goes backwards. Code that waits takes a Clock as an argument, so
/// that tests can set the time.
using Clock = std::function<double()>;

/// The system's steady clock.
[[nodiscard]] inline double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace texplorer
