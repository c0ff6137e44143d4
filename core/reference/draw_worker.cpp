#include "core/reference/draw_worker.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace texplorer::reference {

namespace {

constexpr double noticed = 30; // milliseconds
constexpr int coarsest = 8;
constexpr double firstGuess = 2e-4; // milliseconds a pixel, before anything was drawn

} // namespace

bool sameLevels(const DrawRequest& a, const DrawRequest& b) {
    return std::ranges::equal(
        a.scene.textures, b.scene.textures, [&](const Texture& one, const Texture& other) {
            return imageSettings(one) == imageSettings(other) && a.images.find(one) == b.images.find(other);
        });
}

int coarseness(double expectedMilliseconds) {
    int factor = 1;
    while (factor < coarsest && expectedMilliseconds > noticed * factor * factor)
        factor *= 2;
    return factor;
}

struct DrawWorker::State {
    State(When chosen, std::function<void()> onNews, LevelWork how)
        : when(chosen)
        , wake(std::move(onNews))
        , levels(std::move(how)) {}

    struct Job {
        DrawRequest request;
        std::stop_source all;   ///< other levels are needed, or nobody looks
        std::stop_source whole; ///< anything is different
    };

    const When when;
    const std::function<void()> wake;
    const LevelWork levels;
    std::optional<DrawRequest> wanted; // of the thread that asks
    Picture shown;                     // and what it was given last

    mutable std::mutex mutex; // guards what follows
    std::condition_variable_any arrived;
    mutable std::condition_variable finished;
    std::optional<Job> next;
    std::optional<Job> current;
    bool forgets = false;        // the renderer's memory is to be given back
    std::optional<Picture> news; // of `wanted`, or of what was wanted before

    // Of the thread that draws.
    ReferenceRenderer renderer;
    double millisecondsPerPixel = firstGuess;

    std::jthread thread; // last: it ends before the rest does

    void ask(const DrawRequest& request);
    void run(const std::stop_token& stop);
    void work(const Job& job);
    std::optional<Picture> draw(const DrawRequest& request, int factor, const std::stop_token& stop);
    std::optional<Picture> tryToDraw(const DrawRequest& request, int factor, const std::stop_token& stop);
    void publish(const Job& job, Picture picture);
};

/// Nothing where it was stopped.
std::optional<DrawWorker::Picture> DrawWorker::State::draw(const DrawRequest& request, int factor,
                                                           const std::stop_token& stop) {
    Picture failed;
    failed.whole = factor == 1;
    try {
        return tryToDraw(request, factor, stop);
    } catch (const std::bad_alloc&) {
        failed.problems = {"there is no memory for the picture"};
    } catch (const std::exception& error) {
        failed.problems = {std::string("the picture can't be drawn: ") + error.what()};
    }
    return failed;
}

std::optional<DrawWorker::Picture> DrawWorker::State::tryToDraw(const DrawRequest& request, int factor,
                                                                const std::stop_token& stop) {
    const auto extent = [factor](int whole) { return factor == 1 ? whole : std::max(1, whole / factor); };
    const int width = extent(request.width);
    const int height = extent(request.height);
    LevelWork work = levels;
    work.stop = stop;
    const auto begin = std::chrono::steady_clock::now();
    Result<Drawn> drawn =
        renderer.draw(request.scene, request.images, request.time, width, height,
                      {.anisotropy = request.anisotropy, .levels = std::move(work), .stop = stop});
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    if (!drawn && drawn.error().code == ErrorCode::Cancelled)
        return std::nullopt;
    Picture picture;
    picture.milliseconds = elapsed.count();
    picture.whole = factor == 1;
    if (!drawn) {
        picture.problems = {describe(drawn.error())};
        return picture;
    }
    picture.image = std::make_shared<const Image>(std::move(drawn->image));
    picture.problems = std::move(drawn->problems);
    millisecondsPerPixel = elapsed.count() / (static_cast<double>(width) * height);
    return picture;
}

void DrawWorker::State::publish(const Job& job, Picture picture) {
    {
        const std::scoped_lock lock(mutex);
        if (job.all.stop_requested())
            return;
        // Of an earlier request it is still nearer to what is wanted than what was there before.
        picture.whole = picture.whole && !next;
        news = std::move(picture);
    }
    if (wake)
        wake();
}

void DrawWorker::State::work(const Job& job) {
    const double pixels = static_cast<double>(job.request.width) * job.request.height;
    int factor = coarseness(pixels * millisecondsPerPixel);
    if (std::optional<Picture> first = draw(job.request, factor, job.all.get_token()))
        publish(job, std::move(*first));
    if (factor > 1 && !job.whole.stop_requested()) {
        if (std::optional<Picture> whole = draw(job.request, 1, job.whole.get_token()))
            publish(job, std::move(*whole));
    }
}

void DrawWorker::State::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (arrived.wait(lock, stop, [this] { return next || forgets; }) && !stop.stop_requested()) {
        if (forgets) {
            lock.unlock();
            renderer.rest();
            lock.lock();
            forgets = false;
            finished.notify_all();
            continue;
        }
        current = std::exchange(next, std::nullopt);
        lock.unlock();
        {
            const Job& job = *current; // stays: only this thread changes it
            const std::stop_callback atTheEnd(stop, [&job] {
                job.all.request_stop();
                job.whole.request_stop();
            });
            work(job);
        }
        lock.lock();
        current.reset();
        finished.notify_all();
        lock.unlock();
        if (wake)
            wake();
        lock.lock();
    }
}

void DrawWorker::State::ask(const DrawRequest& request) {
    {
        const std::scoped_lock lock(mutex);
        if (current) {
            current->whole.request_stop();
            if (!sameLevels(current->request, request))
                current->all.request_stop();
        }
        forgets = false;
        next = Job{request, {}, {}};
        if (news)
            news->whole = false;
    }
    if (!thread.joinable()) {
        try {
            thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
        } catch (const std::system_error&) { // no thread to be had: slower, but it works
            const Job job = *std::exchange(next, std::nullopt);
            work(job);
            return;
        }
    }
    arrived.notify_one();
}

DrawWorker::DrawWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

DrawWorker::~DrawWorker() = default;

const DrawWorker::Picture& DrawWorker::picture(const DrawRequest& request) {
    State& state = *state_;
    if (state.wanted != request) {
        state.wanted = request;
        state.shown.whole = false;
        if (state.when == When::AtOnce)
            state.shown = state.draw(request, 1, state.levels.stop).value_or(Picture{});
        else
            state.ask(request);
    }
    const std::scoped_lock lock(state.mutex);
    if (state.news)
        state.shown = *std::exchange(state.news, std::nullopt);
    return state.shown;
}

void DrawWorker::rest() {
    State& state = *state_;
    if (!state.wanted)
        return;
    state.wanted.reset();
    state.shown = {};
    if (!state.thread.joinable())
        return state.renderer.rest();
    const std::scoped_lock lock(state.mutex);
    state.next.reset();
    state.news.reset();
    if (state.current) {
        state.current->all.request_stop();
        state.current->whole.request_stop();
    }
    state.forgets = true;
    state.arrived.notify_one();
}

bool DrawWorker::isDrawing() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->next || state_->current;
}

void DrawWorker::wait() const {
    std::unique_lock lock(state_->mutex);
    state_->finished.wait(lock, [this] { return !state_->next && !state_->current && !state_->forgets; });
}

} // namespace texplorer::reference
