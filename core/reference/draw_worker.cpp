#include "texplorer/reference/draw_worker.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>

namespace texplorer::reference {

namespace {

constexpr double noticed = 30; // milliseconds
constexpr int coarsest = 8;
constexpr double firstGuess = 2e-4; // milliseconds a pixel, before anything was drawn

constexpr FailureWords drawingFailure{N_("not enough memory for the picture"),
                                      N_("the picture can't be drawn")};

} // namespace

int coarseness(double expectedMilliseconds) {
    int factor = 1;
    while (factor < coarsest && expectedMilliseconds > noticed * factor * factor)
        factor *= 2;
    return factor;
}

struct DrawWorker::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::NewestWins, drawingFailure, std::move(wake), levels.stop},
              [this](const Drawing::Task& task) { return work(task); },
              [](const Job& job, const Error& error) {
                  return Answer{job.number, {nullptr, {error.message}, 0, true}};
              }) {}

    struct Job {
        std::uint64_t number = 0;
        std::optional<DrawRequest> request; ///< nothing: give the renderer's memory back
    };
    struct Answer {
        std::uint64_t number = 0; ///< of the job
        Frame frame;
    };
    using Drawing = Worker<Job, Answer>;

    // Of the thread that asks.
    std::optional<DrawRequest> wanted;
    std::uint64_t lastNumber = 0; ///< of the job for `wanted`
    Frame shown;                  ///< what it was given last

    // Of the thread that draws.
    const LevelWork levels;
    ReferenceRenderer renderer;
    double millisecondsPerPixel = firstGuess;

    Drawing worker; // last: it ends before the rest does

    std::optional<Answer> work(const Drawing::Task& task);
    std::optional<Frame> draw(const DrawRequest& request, int factor, const std::stop_token& stop);
    std::optional<Frame> tryToDraw(const DrawRequest& request, int factor, const std::stop_token& stop);
};

/// Nothing where it was stopped.
std::optional<DrawWorker::Frame> DrawWorker::State::draw(const DrawRequest& request, int factor,
                                                         const std::stop_token& stop) {
    Result<std::optional<Frame>> drawn =
        tried(drawingFailure, [&] { return tryToDraw(request, factor, stop); });
    return drawn ? std::move(*drawn) : Frame{nullptr, {drawn.error().message}, 0, factor == 1};
}

std::optional<DrawWorker::Frame> DrawWorker::State::tryToDraw(const DrawRequest& request, int factor,
                                                              const std::stop_token& stop) {
    const auto extent = [factor](int whole) { return factor == 1 ? whole : std::max(1, whole / factor); };
    DrawRequest coarse = request;
    coarse.width = extent(request.width);
    coarse.height = extent(request.height);
    LevelWork work = levels;
    work.stop = stop;
    const auto begin = std::chrono::steady_clock::now();
    Result<texplorer::Frame> drawn = renderer.draw(coarse, {.levels = std::move(work), .stop = stop});
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    if (!drawn && drawn.error().code == ErrorCode::Cancelled)
        return std::nullopt;
    Frame frame;
    frame.milliseconds = elapsed.count();
    frame.whole = factor == 1;
    if (!drawn) {
        frame.problems = {describe(drawn.error())};
        return frame;
    }
    frame.image = std::make_shared<const Image>(std::move(drawn->image));
    frame.problems = std::move(drawn->problems);
    millisecondsPerPixel = elapsed.count() / (static_cast<double>(coarse.width) * coarse.height);
    return frame;
}

std::optional<DrawWorker::State::Answer> DrawWorker::State::work(const Drawing::Task& task) {
    const auto& [number, request] = task.job();
    if (!request) {
        renderer.rest();
        return std::nullopt;
    }
    const double pixels = static_cast<double>(request->width) * request->height;
    const int factor = task.atOnce() ? 1 : coarseness(pixels * millisecondsPerPixel);
    std::optional<Frame> drawn = draw(*request, factor, task.stop());
    if (drawn && factor > 1) {
        task.give({number, std::move(*drawn)});
        drawn = draw(*request, 1, task.superseded());
    }
    return drawn ? std::optional(Answer{number, std::move(*drawn)}) : std::nullopt;
}

DrawWorker::DrawWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

DrawWorker::~DrawWorker() = default;

const DrawWorker::Frame& DrawWorker::frame(const DrawRequest& request) {
    State& state = *state_;
    if (state.wanted != request) {
        state.wanted = request;
        state.shown.whole = false;
        state.worker.drop(
            [&](const State::Job& job) { return job.request && !sameLevels(*job.request, request); });
        state.worker.ask({++state.lastNumber, request});
    }
    for (State::Answer& answer : state.worker.take()) {
        state.shown = std::move(answer.frame);
        // Of an earlier request it is still nearer to what is wanted than what was there before.
        state.shown.whole = state.shown.whole && answer.number == state.lastNumber;
    }
    return state.shown;
}

void DrawWorker::rest() {
    State& state = *state_;
    if (!state.wanted)
        return;
    state.wanted.reset();
    state.shown = {};
    state.worker.clear();
    state.worker.ask({++state.lastNumber, std::nullopt});
}

bool DrawWorker::isDrawing() const {
    return state_->wanted && state_->worker.isWorking();
}

void DrawWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::reference
