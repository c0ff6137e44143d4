#include "app/screenshot/output/interrupts.h"

#include <csignal>
#include <pthread.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

// All threads block the signals; one waits for them, and may do what a signal handler may not.
std::mutex ending; // held by whom may not be ended now
std::stop_source* asked = nullptr;
int received = 0;
bool outputBegun = false;

void waitForSignals(sigset_t signals) {
    for (int signal = 0; sigwait(&signals, &signal) == 0;) {
        const std::lock_guard lock(ending);
        received = signal;
        if (asked != nullptr && asked->request_stop())
            continue;
        _exit(complainInterrupted()); // destructors would pull things away from the other threads
    }
}

bool isIgnored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

void watchInterrupts() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!isIgnored(signal))
            sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    try {
        std::thread(waitForSignals, signals).detach();
    } catch (const std::system_error&) { // no thread to be had: signals end the program as they do elsewhere
        pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    }
}

void ignoreInterrupts() {
    ending.lock(); // for good
}

void askToStop(std::stop_source* work) {
    const std::lock_guard lock(ending);
    asked = work;
}

ExitCode complainInterrupted(const Sentence& written) {
    complain({ErrorCode::Cancelled,
              !written.empty() ? Sentence("interrupted; {0}", written)
              : outputBegun    ? Sentence(N_("interrupted"))
                               : Sentence(N_("interrupted; nothing was written")),
              {}});
    return static_cast<ExitCode>(128 + received);
}

void outputBegins() {
    const std::lock_guard lock(ending);
    outputBegun = true;
}

Uninterrupted::Uninterrupted()
    : lock_(ending) {
    outputBegun = true;
}

} // namespace texplorer::screenshot
