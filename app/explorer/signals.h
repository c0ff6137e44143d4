#pragma once

#include <functional>
#include <memory>

namespace texplorer::explorer {

/// Handles SIGTERM, SIGHUP and SIGINT as requests to quit, and SIGALRM, on its own thread, so that it works
/// even while the window's loop is busy or hangs in the driver. Create it before any other thread: threads
/// inherit the blocked signals. A signal that was ignored at the start stays ignored (nohup). If the program
/// has not ended a few seconds after a request, or if there is a second one, the signal ends it.
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

    /// Sets the action that runs on that thread when the time of `setAlarm` is over. When this returns, the
    /// previous action is no longer running.
    void onAlarm(std::function<void()> action);
    /// In how many seconds the action runs, once; 0: it does not. It needs no thread and no wake-up. Does
    /// nothing after a request to quit.
    void setAlarm(double seconds);

    /// The user has closed the window: if the program has not ended a few seconds later, it ends with this
    /// exit status.
    void endSoon(int status);

    /// Stops the timer and restores the signals of the calling thread: the program that it then starts in
    /// place of this one inherits both.
    void restore();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Ends the process by the default action of this signal, so that the parent process sees the reason.
[[noreturn]] void endBy(int signal);

} // namespace texplorer::explorer
