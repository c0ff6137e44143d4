#include "app/explorer/signals.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <pthread.h>
#include <thread>
#include <utility>

namespace texplorer::explorer {
namespace {

constexpr std::array requests{SIGTERM, SIGHUP, SIGINT};
constexpr int farewell = SIGUSR2; // ends the signal thread; sent only to it

bool isIgnored(int signal) {
    struct sigaction now = {};
    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

} // namespace

struct Signals::State {
    sigset_t awaited{};
    sigset_t before{};
    std::atomic<int> received = 0;
    std::atomic<bool> ending = false;
    std::mutex mutex; // protects the action
    std::function<void()> action;
    std::thread thread;

    void work();
};

Signals::Signals()
    : state_(std::make_unique<State>()) {
    sigemptyset(&state_->awaited);
    for (const int signal : requests) {
        if (!isIgnored(signal))
            sigaddset(&state_->awaited, signal);
    }
    sigaddset(&state_->awaited, farewell);
    ::pthread_sigmask(SIG_BLOCK, &state_->awaited, &state_->before);
    state_->thread = std::thread([this] { state_->work(); });
}

Signals::~Signals() {
    state_->ending = true;
    ::pthread_kill(state_->thread.native_handle(), farewell);
    state_->thread.join();
    ::pthread_sigmask(SIG_SETMASK, &state_->before, nullptr);
}

void Signals::State::work() {
    for (;;) {
        int signal = 0;
        if (::sigwait(&awaited, &signal) != 0)
            continue;
        if (signal == farewell) {
            if (ending)
                return;
            continue; // from another source
        }
        if (received.exchange(signal) != 0)
            endBy(signal);
        const std::scoped_lock lock(mutex);
        if (action)
            action();
    }
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
