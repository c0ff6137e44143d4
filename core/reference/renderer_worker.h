#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/reference/draw.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace texplorer::reference {

/// A renderer on a thread of its own that answers only the newest request. It is the base of window workers
/// whose new answer replaces the old one.
template<class Request, class Answer>
class RendererWorker {
    using Job = std::optional<Request>; ///< empty: free the renderer's memory
    using Answered = std::shared_ptr<const Answer>;
    using Asking = Worker<Job, Answered>;

public:
    /// Calls the renderer; returns nullptr if it was stopped.
    using Work = Answered (*)(ReferenceRenderer& renderer, const Request& request,
                              const DrawOptions& options);

    RendererWorker(When when, FailureWords words, std::function<void()> wake, LevelWork levels, Work work)
        : work_(work)
        , levels_(std::move(levels))
        , worker_(
              {when, JobOrder::NewestWins, words, std::move(wake), levels_.stop},
              [this](const typename Asking::Task& task) { return answerOf(task); },
              // The last answer stays.
              [](const Job&, const Error&) { return Answered(); }) {}

    /// Returns the newest answer; nullptr: none yet. For a new request, `isUseless(earlier)` decides whether
    /// the work on an earlier one is stopped.
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

    /// Stops the work, and frees the answer and the textures. For a hidden view.
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

    // Used by the calling thread.
    std::optional<Request> wanted_;
    Answered newest_;

    // Used by the working thread.
    const Work work_;
    const LevelWork levels_;
    ReferenceRenderer renderer_;

    Asking worker_; // last: it ends before the other members
};

} // namespace texplorer::reference
