#include "core/reference/probe_worker.h"

#include "core/reference/probe.h"

#include <condition_variable>
#include <mutex>
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
    std::stop_source stop;
    bool working = false;
    DrawRequest current; // what is being worked on
    std::shared_ptr<const Answer> newest;

    std::jthread thread; // last, so that it ends first

    [[nodiscard]] std::shared_ptr<const Answer> answer(const ProbeRequest& request, std::stop_token token) {
        auto made = std::make_shared<Answer>();
        made->request = request;
        const auto& [scene, images, time, width, height, anisotropy] = request.picture;
        DrawOptions options;
        options.anisotropy = anisotropy;
        options.levels = levels;
        if (token.stop_possible()) // else the caller's own stays
            options.levels.stop = token;
        options.stop = token;
        if (request.pixel)
            made->explanation = renderer.probe(scene, images, time, width, height, *request.pixel, options);
        if (request.texel)
            made->contributions =
                renderer.contributions(scene, images, time, width, height, *request.texel, options);
        return made;
    }

    void run(const std::stop_token& end) {
        std::unique_lock lock(mutex);
        while (arrived.wait(lock, end, [this] { return next.has_value(); }) && !end.stop_requested()) {
            const ProbeRequest request = *std::exchange(next, std::nullopt);
            stop = std::stop_source();
            const std::stop_token token = stop.get_token();
            working = true;
            current = request.picture;
            lock.unlock();
            std::shared_ptr<const Answer> made = answer(request, token);
            lock.lock();
            working = false;
            const bool wasStopped = token.stop_requested();
            if (!wasStopped)
                newest = std::move(made);
            finished.notify_all();
            if (wasStopped || !wake)
                continue;
            lock.unlock();
            wake();
            lock.lock();
        }
    }
};

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
        state.newest = state.answer(request, {});
        return state.newest;
    }
    const std::lock_guard lock(state.mutex);
    // Making levels can take long; what follows is soon done, and while a scene moves it should be.
    if (state.working && state.current.scene.textures != request.picture.scene.textures)
        state.stop.request_stop();
    state.next = request;
    state.arrived.notify_all();
    return state.newest;
}

void ProbeWorker::wait() const {
    std::unique_lock lock(state_->mutex);
    state_->finished.wait(lock, [this] { return !state_->working && !state_->next; });
}

} // namespace texplorer::reference
