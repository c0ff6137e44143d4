#include "app/screenshot/output/interrupts.h"

#include <chrono>
#include <csignal>
#include <pthread.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

// All threads block the signals; one waits for them, and may do what a signal handler may not.
std::recursive_mutex ending; // held by whom may not be ended now
std::timed_mutex printing;   // held while standard output is written
std::stop_source* asked = nullptr;
int received = 0;
bool outputBegun = false;
bool printed = false;
constexpr std::chrono::seconds maxPrinting{5}; // of a document that no program reads

void waitForSignals(sigset_t signals) {
    for (int signal = 0; sigwait(&signals, &signal) == 0;) {
        const std::lock_guard lock(ending);
        received = signal;
        if (asked != nullptr && asked->request_stop())
            continue;
        if (printing.try_lock_for(maxPrinting)) // not in the middle of a document
            printing.unlock();
        const ExitCode status = complainInterrupted();
        printProblems();
        _exit(status); // destructors would pull things away from the other threads
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

Printing::Printing() {
    const std::lock_guard lock(ending);
    outputBegun = printed = true;
    lock_ = std::unique_lock(printing);
}

bool hasPrinted() {
    const std::lock_guard lock(ending);
    return printed;
}

} // namespace texplorer::screenshot
