#include "app/explorer/signals.h"

#include "texplorer/base/clock.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <optional>
#include <pthread.h>
#include <sys/time.h>
#include <thread>
#include <utility>

namespace texplorer::explorer {
namespace {

constexpr std::array requests{SIGTERM, SIGHUP, SIGINT};
constexpr int farewell = SIGUSR2;  // ends the signal thread; sent only to it
constexpr double secondsToEnd = 5; // after a request; then a thread hangs, in the driver or in its work

bool isIgnored(int signal) {
    struct sigaction now = {};
    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

void setTimer(double seconds) {
    constexpr double shortest = 1e-3; // 0 would switch it off
    struct itimerval timer = {};
    if (seconds > 0) {
        const double rounded = std::max(seconds, shortest);
        timer.it_value.tv_sec = static_cast<time_t>(rounded);
        timer.it_value.tv_usec = static_cast<suseconds_t>((rounded - std::floor(rounded)) * 1e6);
    }
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

/// A SIGALRM that nothing has taken would end the process when it is no longer blocked.
void dropAlarm() {
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, SIGALRM);
    const struct timespec none = {};
    ::sigtimedwait(&only, nullptr, &none);
}

} // namespace

struct Signals::State {
    sigset_t awaited{};
    sigset_t before{};
    std::atomic<int> received = 0;
    std::atomic<bool> ending = false;
    std::mutex mutex; // protects the actions
    std::function<void()> action;
    std::function<void()> alarm;
    std::mutex timing;         // protects what follows, and the timer
    std::optional<double> due; // when the program has to have ended; nothing: it goes on
    int status = 0;            // its exit status then, unless a signal was received
    std::thread thread;

    void work();
    void request(int signal);
    void ring();
    void endSoon(int exitStatus);
    [[nodiscard]] bool isEnding();
};

Signals::Signals()
    : state_(std::make_unique<State>()) {
    sigemptyset(&state_->awaited);
    for (const int signal : requests) {
        if (!isIgnored(signal))
            sigaddset(&state_->awaited, signal);
    }
    sigaddset(&state_->awaited, farewell);
    sigaddset(&state_->awaited, SIGALRM);
    ::pthread_sigmask(SIG_BLOCK, &state_->awaited, &state_->before);
    state_->thread = std::thread([this] { state_->work(); });
}

Signals::~Signals() {
    state_->ending = true;
    ::pthread_kill(state_->thread.native_handle(), farewell);
    state_->thread.join();
    setTimer(0);
    dropAlarm();
    ::pthread_sigmask(SIG_SETMASK, &state_->before, nullptr);
}

void Signals::State::work() {
    for (;;) {
        int signal = 0;
        if (::sigwait(&awaited, &signal) != 0)
            continue;
        if (signal == SIGALRM)
            ring();
        else if (signal != farewell)
            request(signal);
        else if (ending)
            return; // else from another source
    }
}

void Signals::State::request(int signal) {
    if (received.exchange(signal) != 0)
        endBy(signal);
    {
        const std::scoped_lock lock(mutex);
        if (action)
            action();
    }
    endSoon(status);
}

void Signals::State::ring() {
    if (isEnding())
        return;
    const std::scoped_lock lock(mutex);
    if (alarm)
        alarm();
}

void Signals::State::endSoon(int exitStatus) {
    const std::scoped_lock lock(timing);
    status = exitStatus;
    due = steadySeconds() + secondsToEnd;
    setTimer(secondsToEnd);
}

/// Ends the program when the time to end is over.
bool Signals::State::isEnding() {
    const std::scoped_lock lock(timing);
    if (!due)
        return false;
    if (const double left = *due - steadySeconds(); left > 0) {
        setTimer(left); // the alarm was for a frame, or from another process
        return true;
    }
    if (received != 0)
        endBy(received);
    std::_Exit(status);
}

void Signals::onRequest(std::function<void()> action) {
    const std::scoped_lock lock(state_->mutex);
    state_->action = std::move(action);
    if (state_->action && received() != 0) // a signal arrived before an action was set
        state_->action();
}

int Signals::received() const {
    return state_->received;
}

void Signals::onAlarm(std::function<void()> action) {
    const std::scoped_lock lock(state_->mutex);
    state_->alarm = std::move(action);
}

void Signals::setAlarm(double seconds) {
    const std::scoped_lock lock(state_->timing);
    if (!state_->due)
        setTimer(seconds);
}

void Signals::endSoon(int status) {
    state_->endSoon(status);
}

void Signals::restore() {
    setTimer(0);
    dropAlarm();
    ::pthread_sigmask(SIG_SETMASK, &state_->before, nullptr);
}

void endBy(int signal) {
    std::signal(signal, SIG_DFL);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    std::raise(signal);
    std::_Exit(128 + signal);
}

} // namespace texplorer::explorer
