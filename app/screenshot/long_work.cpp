#include "app/screenshot/long_work.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <semaphore.h>
#include <system_error>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

constexpr std::array signals{SIGINT, SIGTERM};

// A signal handler may do hardly more than this: no stop can be requested there.
volatile std::sig_atomic_t signalled = 0;
sem_t woken;

void onSignal(int /*signal*/) {
    signalled = 1;
    sem_post(&woken);
}

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

LongWork::LongWork(std::string what)
    : what_(std::move(what))
    , start_(seconds())
    , terminal_(isatty(STDERR_FILENO) == 1) {
    signalled = 0;
    sem_init(&woken, 0, 0);
    try {
        watcher_ = std::jthread([this] {
            while (sem_wait(&woken) != 0) // interrupted, perhaps by the very signal
                continue;
            if (signalled != 0)
                stop_.request_stop();
        });
    } catch (const std::system_error&) { // no thread to be had: Ctrl+C ends the program, as it does elsewhere
        return;
    }
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    for (const int signal : signals)
        sigaction(signal, &action, nullptr);
}

LongWork::~LongWork() {
    finish();
}

void LongWork::finish() {
    if (watcher_.joinable()) {
        for (const int signal : signals)
            std::signal(signal, SIG_DFL);
        sem_post(&woken);
        watcher_.join();
    }
    if (shownPercent_ >= 0)
        std::fprintf(stderr, "\r\033[K");
    shownPercent_ = -1;
    terminal_ = false;
}

void LongWork::report(float done) {
    if (!terminal_ || seconds() - start_ < 1)
        return;
    const int percent = static_cast<int>(done * 100);
    if (shownPercent_.exchange(percent) != percent)
        std::fprintf(stderr, "\r%s: %d %%", what_.c_str(), percent);
}

} // namespace texplorer::screenshot
