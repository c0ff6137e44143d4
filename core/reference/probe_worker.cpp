#include "core/reference/probe_worker.h"

#include "core/base/worker.h"
#include "core/reference/probe.h"

#include <stop_token>
#include <utility>

namespace texplorer::reference {

namespace {

constexpr FailureWords probingFailure{"there is no memory for the answer", "there is no answer"};

} // namespace

struct ProbeWorker::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::NewestWins, probingFailure, std::move(wake), levels.stop},
              [this](const Probing::Task& task) { return work(task); },
              // What was answered last stays.
              [](const Job&, const Error&) { return std::shared_ptr<const Answer>(); }) {}

    using Job = std::optional<ProbeRequest>; ///< nothing: give the renderer's memory back
    using Probing = Worker<Job, std::shared_ptr<const Answer>>;

    // Of the thread that asks.
    std::optional<ProbeRequest> wanted;
    std::shared_ptr<const Answer> newest;

    // Of the thread that works.
    const LevelWork levels;
    ReferenceRenderer renderer;

    Probing worker; // last: it ends before the rest does

    [[nodiscard]] std::optional<std::shared_ptr<const Answer>> work(const Probing::Task& task);
};

std::optional<std::shared_ptr<const ProbeWorker::Answer>>
ProbeWorker::State::work(const Probing::Task& task) {
    if (!task.job()) {
        renderer.rest();
        return std::nullopt;
    }
    auto made = std::make_shared<Answer>();
    made->request = *task.job();
    const DrawRequest& asked = made->request.picture;
    DrawOptions options{.levels = levels, .stop = task.stop()};
    options.levels.stop = task.stop();
    if (made->request.pixel)
        made->explanation =
            tried(probingFailure, [&] { return renderer.probe(asked, *made->request.pixel, options); });
    if (made->request.texel)
        made->contributions = tried(
            probingFailure, [&] { return renderer.contributions(asked, *made->request.texel, options); });
    return made;
}

ProbeWorker::ProbeWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

ProbeWorker::~ProbeWorker() = default;

std::shared_ptr<const ProbeWorker::Answer> ProbeWorker::answer(const ProbeRequest& request) {
    State& state = *state_;
    if (state.wanted != request) {
        state.wanted = request;
        // What takes long is to make levels and to find a texel's pixels. The rest is soon done, and while a
        // scene moves it should be, or the user would see nothing of either.
        state.worker.drop([&](const State::Job& job) {
            return job && (!sameLevels(job->picture, request.picture) ||
                           (job->texel && job->texel != request.texel));
        });
        state.worker.ask(request);
    }
    for (std::shared_ptr<const Answer>& answer : state.worker.take())
        if (answer)
            state.newest = std::move(answer);
    return state.newest;
}

void ProbeWorker::rest() {
    State& state = *state_;
    if (!state.wanted)
        return;
    state.wanted.reset();
    state.newest.reset();
    state.worker.clear();
    state.worker.ask(std::nullopt);
}

void ProbeWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::reference
