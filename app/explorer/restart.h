#pragma once

#include "app/explorer/signals.h"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::explorer {

/// Starts the program again in place of this process, with the reference renderer: the window's thread hangs
/// in the driver and can't be asked for anything. What to show then is noted before.
class Restart {
public:
    /// What the new window shows.
    struct Reopened {
        std::vector<std::string> arguments; ///< files, or --lesson with its value
        /// Whether the driver draws the scene, so that the reference can be expected to do better.
        bool helps = true;
    };

    /// `program`: how it was called. `options`: all but --renderer and what is shown.
    Restart(Signals& signals, std::string program, std::vector<std::string> options);
    Restart(const Restart&) = delete;
    Restart& operator=(const Restart&) = delete;

    /// Call before the driver is asked to draw.
    void note(Reopened reopened);

    /// Call on the thread of the signals: says that the driver did not finish within these seconds, and
    /// starts the program again. If that does not help, or fails, it ends with status 1.
    [[noreturn]] void run(double seconds);

    /// Call before any thread starts. If this process is such a new one: how many seconds the driver had.
    [[nodiscard]] static std::optional<double> takeReason();

private:
    [[nodiscard]] std::vector<std::string> words() const;

    Signals& signals_;
    std::string program_;
    std::vector<std::string> options_;
    std::mutex mutex_;
    Reopened reopened_;
};

} // namespace texplorer::explorer
