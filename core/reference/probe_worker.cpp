#include "core/reference/probe_worker.h"

#include "core/reference/probe.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace texplorer::reference {

struct ProbeWorker::State {
    State(When chosen, std::function<void()> onNews, LevelWork how)
        : when(chosen)
        , wake(std::move(onNews))
        , levels(std::move(how)) {}

    const When when;
    const std::function<void()> wake;
    const LevelWork levels;
    std::optional<ProbeRequest> wanted; // of the thread that asks
    ReferenceRenderer renderer;         // of the thread that works

    mutable std::mutex mutex; // guards what follows
    std::condition_variable_any arrived;
    mutable std::condition_variable finished;
    std::optional<ProbeRequest> next;
    std::optional<ProbeRequest> current; // what is being worked on
    std::stop_source stop;               // of `current`
    bool forgets = false;                // the renderer's memory is to be given back
    std::shared_ptr<const Answer> newest;

    std::jthread thread; // last, so that it ends first

    [[nodiscard]] std::shared_ptr<const Answer> answer(const ProbeRequest& request,
                                                       const std::stop_token& token);
    void run(const std::stop_token& end);
};

namespace {

/// What `ask` returns, or why it can't.
template<class Ask>
auto tried(const Ask& ask) -> decltype(ask()) {
    try {
        return ask();
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "there is no memory for the answer");
    } catch (const std::exception& error) {
        return fail(ErrorCode::Unsupported, std::string("there is no answer: ") + error.what());
    }
}

} // namespace

std::shared_ptr<const ProbeWorker::Answer> ProbeWorker::State::answer(const ProbeRequest& request,
                                                                      const std::stop_token& token) try {
    auto made = std::make_shared<Answer>();
    made->request = request;
    const auto& asked = request.picture; // no structured binding: clang 14's lambdas can't take one
    DrawOptions options{.anisotropy = asked.anisotropy, .levels = levels, .stop = token};
    options.levels.stop = token;
    if (request.pixel)
        made->explanation = tried([&] {
            return renderer.probe(asked.scene, asked.images, asked.time, asked.width, asked.height,
                                  *request.pixel, options);
        });
    if (request.texel)
        made->contributions = tried([&] {
            return renderer.contributions(asked.scene, asked.images, asked.time, asked.width, asked.height,
                                          *request.texel, options);
        });
    return made;
} catch (const std::bad_alloc&) { // not even for a sentence: what was answered last stays
    return nullptr;
}

void ProbeWorker::State::run(const std::stop_token& end) {
    std::unique_lock lock(mutex);
    while (arrived.wait(lock, end, [this] { return next || forgets; }) && !end.stop_requested()) {
        if (forgets) {
            lock.unlock();
            renderer.rest();
            lock.lock();
            forgets = false;
            finished.notify_all();
            continue;
        }
        current = std::exchange(next, std::nullopt);
        stop = std::stop_source();
        const std::stop_token token = stop.get_token();
        lock.unlock();
        std::shared_ptr<const Answer> made = answer(*current, token);
        lock.lock();
        if (made && !token.stop_requested()) {
            newest = std::move(made);
            lock.unlock();
            if (wake)
                wake();
            lock.lock();
        }
        current.reset();
        finished.notify_all();
    }
}

ProbeWorker::ProbeWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

ProbeWorker::~ProbeWorker() {
    const std::lock_guard lock(state_->mutex);
    state_->stop.request_stop();
    state_->thread.request_stop(); // joined by the member's own destructor, after the lock is gone
}

std::shared_ptr<const ProbeWorker::Answer> ProbeWorker::answer(const ProbeRequest& request) {
    State& state = *state_;
    if (state.wanted == request) {
        const std::lock_guard lock(state.mutex);
        return state.newest;
    }
    state.wanted = request;
    if (state.when == When::WhenReady && !state.thread.joinable()) {
        try {
            state.thread = std::jthread([&state](const std::stop_token& end) { state.run(end); });
        } catch (const std::system_error&) { // no thread to be had: whoever asks waits after all
        }
    }
    if (!state.thread.joinable()) {
        state.newest = state.answer(request, state.levels.stop);
        return state.newest;
    }
    const std::lock_guard lock(state.mutex);
    // What takes long is to make levels and to find a texel's pixels. The rest is soon done, and while a
    // scene moves it should be, or the user would see nothing of either.
    if (state.current && (!sameLevels(state.current->picture, request.picture) ||
                          (state.current->texel && state.current->texel != request.texel)))
        state.stop.request_stop();
    state.forgets = false;
    state.next = request;
    state.arrived.notify_all();
    return state.newest;
}

void ProbeWorker::rest() {
    State& state = *state_;
    if (!state.wanted)
        return;
    state.wanted.reset();
    if (!state.thread.joinable()) {
        state.newest.reset();
        return state.renderer.rest();
    }
    const std::lock_guard lock(state.mutex);
    state.next.reset();
    state.newest.reset();
    state.stop.request_stop();
    state.forgets = true;
    state.arrived.notify_all();
}

void ProbeWorker::wait() const {
    std::unique_lock lock(state_->mutex);
    state_->finished.wait(lock, [this] { return !state_->current && !state_->next && !state_->forgets; });
}

} // namespace texplorer::reference
