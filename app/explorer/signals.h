#pragma once

#include <functional>
#include <memory>

namespace texplorer::explorer {

/// SIGTERM, SIGHUP and SIGINT as requests to end, on a thread of its own, so that the window's loop may do
/// what it likes, or hang in the driver. To be made before any other thread: they inherit which signals are
/// left to it. A signal that was ignored when the program started stays so (nohup). A second one ends the
/// program at once.
class Signals {
public:
    Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;
    ~Signals();

    /// What is done on that thread when the first one comes; nothing: it waits until there is something. Once
    /// this returns, what was set before is no longer running.
    void onRequest(std::function<void()> action);

    /// The signal that came, or 0.
    [[nodiscard]] int received() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Ends the process as this signal does where nobody waits for it: its parent process sees why.
[[noreturn]] void endBy(int signal);

} // namespace texplorer::explorer
