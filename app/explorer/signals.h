#pragma once

#include <functional>
#include <memory>

namespace texplorer::explorer {

/// Handles SIGTERM, SIGHUP and SIGINT as requests to quit, on its own thread, so that it works even while the
/// window's loop is busy or hangs in the driver. Create it before any other thread: threads inherit the
/// blocked signals. A signal that was ignored at the start stays ignored (nohup). A second signal ends the
/// program at once.
class Signals {
public:
    Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;
    ~Signals();

    /// Sets the action that runs on that thread at the first signal; without one, the signal waits for an
    /// action. When this returns, the previous action is no longer running.
    void onRequest(std::function<void()> action);

    /// The signal that was received, or 0.
    [[nodiscard]] int received() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Ends the process by the default action of this signal, so that the parent process sees the reason.
[[noreturn]] void endBy(int signal);

} // namespace texplorer::explorer
