#pragma once

#include "core/base/worker.h"
#include "core/reference/draw.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace texplorer::reference {

/// A renderer on a thread of its own that answers the newest request: what workers for a window have in
/// common whose answers replace each other whole.
template<class Request, class Answer>
class RendererWorker {
    using Job = std::optional<Request>; ///< nothing: give the renderer's memory back
    using Answered = std::shared_ptr<const Answer>;
    using Asking = Worker<Job, Answered>;

public:
    /// Asks the renderer; nullptr where it was stopped.
    using Work = Answered (*)(ReferenceRenderer& renderer, const Request& request,
                              const DrawOptions& options);

    RendererWorker(When when, FailureWords words, std::function<void()> wake, LevelWork levels, Work work)
        : work_(work)
        , levels_(std::move(levels))
        , worker_(
              {when, JobOrder::NewestWins, words, std::move(wake), levels_.stop},
              [this](const typename Asking::Task& task) { return answerOf(task); },
              // What was answered last stays.
              [](const Job&, const Error&) { return Answered(); }) {}

    /// The newest answer; nullptr: none yet. Of a new request, `isUseless(earlier)` says whether the work on
    /// an earlier one is to end.
    template<class IsUseless>
    [[nodiscard]] Answered answer(const Request& request, const IsUseless& isUseless) {
        if (wanted_ != request) {
            wanted_ = request;
            worker_.drop([&](const Job& job) { return job && isUseless(*job); });
            worker_.ask(request);
        }
        for (Answered& each : worker_.take()) {
            if (each)
                newest_ = std::move(each);
        }
        return newest_;
    }

    /// Nobody asks any more: ends what is being worked on, and forgets the answer and the textures.
    void rest() {
        if (!wanted_)
            return;
        wanted_.reset();
        newest_.reset();
        worker_.clear();
        worker_.ask(std::nullopt);
    }

    void wait() const { worker_.wait(); }

private:
    std::optional<Answered> answerOf(const typename Asking::Task& task) {
        if (!task.job()) {
            renderer_.rest();
            return std::nullopt;
        }
        DrawOptions options{.levels = levels_, .stop = task.stop()};
        options.levels.stop = task.stop();
        Answered made = work_(renderer_, *task.job(), options);
        return made ? std::optional(std::move(made)) : std::nullopt;
    }

    // Of the thread that asks.
    std::optional<Request> wanted_;
    Answered newest_;

    // Of the thread that works.
    const Work work_;
    const LevelWork levels_;
    ReferenceRenderer renderer_;

    Asking worker_; // last: it ends before the rest does
};

} // namespace texplorer::reference
