#include "core/reference/level_map_worker.h"

#include <optional>
#include <stop_token>
#include <utility>

namespace texplorer::reference {

namespace {

constexpr FailureWords mappingFailure{"there is no memory for the levels of the pixels",
                                      "the levels of the pixels can't be found"};

} // namespace

struct LevelMapWorker::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::NewestWins, mappingFailure, std::move(wake), levels.stop},
              [this](const Mapping::Task& task) { return work(task); },
              // What was answered last stays.
              [](const Job&, const Error&) { return std::shared_ptr<const Answer>(); }) {}

    using Job = std::optional<LevelMapRequest>; ///< nothing: give the renderer's memory back
    using Mapping = Worker<Job, std::shared_ptr<const Answer>>;

    // Of the thread that asks.
    std::optional<LevelMapRequest> wanted;
    std::shared_ptr<const Answer> newest;

    // Of the thread that works.
    const LevelWork levels;
    ReferenceRenderer renderer;

    Mapping worker; // last: it ends before the rest does

    [[nodiscard]] std::optional<std::shared_ptr<const Answer>> work(const Mapping::Task& task);
};

std::optional<std::shared_ptr<const LevelMapWorker::Answer>>
LevelMapWorker::State::work(const Mapping::Task& task) {
    if (!task.job()) {
        renderer.rest();
        return std::nullopt;
    }
    const LevelMapRequest& asked = *task.job();
    DrawOptions options{.levels = levels, .stop = task.stop()};
    options.levels.stop = task.stop();
    Result<LevelMap> map =
        tried(mappingFailure, [&] { return renderer.levels(asked.picture, asked.unit, options); });
    if (!map && map.error().code == ErrorCode::Cancelled)
        return std::nullopt;
    auto made = std::make_shared<Answer>(Answer{asked, std::move(map)});
    if (made->map && asked.shown != Shown::Picture)
        made->colors = std::make_shared<const Image>(falseColors(*made->map, asked.shown));
    return made;
}

LevelMapWorker::LevelMapWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

LevelMapWorker::~LevelMapWorker() = default;

std::shared_ptr<const LevelMapWorker::Answer> LevelMapWorker::answer(const LevelMapRequest& request) {
    State& state = *state_;
    if (state.wanted != request) {
        state.wanted = request;
        state.worker.drop(
            [&](const State::Job& job) { return job && !sameLevels(job->picture, request.picture); });
        state.worker.ask(request);
    }
    for (std::shared_ptr<const Answer>& answer : state.worker.take())
        if (answer)
            state.newest = std::move(answer);
    return state.newest;
}

void LevelMapWorker::rest() {
    State& state = *state_;
    if (!state.wanted)
        return;
    state.wanted.reset();
    state.newest.reset();
    state.worker.clear();
    state.worker.ask(std::nullopt);
}

void LevelMapWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::reference
