#pragma once

// Questions about drivers, answered by a process of its own for each: one that crashes or hangs is an answer,
// too.

#include "app/screenshot/gl/driver_report.h"

#include <optional>
#include <string>

namespace texplorer::screenshot {

/// A context that was found, or a library whose contexts can't even be listed, with what came of asking it.
struct DriverAnswer {
    view::ContextChoice context;
    Result<DriverReport> report;
};

/// Of every context that there is. `seconds`: after which a driver that is asked has hung. The error: there
/// are no processes to be had.
[[nodiscard]] Result<std::vector<DriverAnswer>> askDrivers(int seconds);

inline constexpr int defaultDriverSeconds = 20;

/// Of one. An error may be the driver's end: "the driver crashed: SIGABRT, aborted".
[[nodiscard]] Result<DriverReport> askDriver(const view::ContextChoice& choice,
                                             int seconds = defaultDriverSeconds);

/// In such a process: answers until nobody asks any more. Nothing: this is none, but a program that was
/// called.
[[nodiscard]] std::optional<int> answerQuestions(int argc, const char* const* argv);

} // namespace texplorer::screenshot
