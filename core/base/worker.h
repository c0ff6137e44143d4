#pragma once

#include "texplorer/base/tried.h"

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace texplorer {

/// Where long work runs.
enum class When : std::uint8_t {
    AtOnce,    ///< on the calling thread, which blocks: for programs without a window
    WhenReady, ///< on a thread of its own; the caller looks again after `wake`
};

/// Which jobs are done.
enum class JobOrder : std::uint8_t {
    Queue,      ///< all, in the order of the calls
    NewestWins, ///< only the newest: it replaces the waiting job, and only the last answer is kept
};

struct WorkerSetup {
    When when = When::WhenReady;
    JobOrder order = JobOrder::Queue;
    FailureWords words{N_("not enough memory for it"), N_("it failed")};
    /// Called on the working thread whenever `take` or `progress` has something new; must not throw.
    std::function<void()> wake{};
    std::stop_token stop{}; ///< stops the current job
};

/// Runs jobs on a thread of its own, one after the other. If there is no thread or none is wanted, `ask` runs
/// them. All functions must be called from one thread; the first `ask` starts the other. An exception of the
/// work becomes an answer.
template<class Job, class Answer, class Progress = std::monostate>
class Worker {
    struct Current {
        Job job;
        std::optional<Progress> progress;
        std::stop_token callersStop;
        std::stop_source stop{};
        std::stop_source superseded{};
        bool atOnce = false;
        bool dropped = false;
    };

public:
    /// The current job, as its work sees it.
    class Task {
    public:
        [[nodiscard]] const Job& job() const { return current_.job; }
        /// Whether the caller is blocked until the answer.
        [[nodiscard]] bool atOnce() const { return current_.atOnce; }
        /// Requested when the answer is no longer wanted.
        [[nodiscard]] std::stop_token stop() const { return tokenOf(current_.stop); }
        /// Requested in the same case; with NewestWins, also as soon as there is a newer job.
        [[nodiscard]] std::stop_token superseded() const { return tokenOf(current_.superseded); }

        /// Delivers an answer before the last one.
        void give(Answer answer) const {
            if (worker_.keep(current_, std::move(answer)))
                worker_.tell();
        }
        void report(Progress progress) const {
            {
                const std::scoped_lock lock(worker_.mutex_);
                current_.progress = std::move(progress);
            }
            worker_.tell();
        }

    private:
        friend Worker;
        Task(Worker& worker, Current& current)
            : worker_(worker)
            , current_(current) {}
        [[nodiscard]] std::stop_token tokenOf(const std::stop_source& source) const {
            return current_.atOnce ? current_.callersStop : source.get_token();
        }

        Worker& worker_;
        Current& current_;
    };

    /// Returns the last answer; empty if there is none.
    using Work = std::function<std::optional<Answer>(const Task&)>;
    /// Makes the answer for work that threw.
    using Failed = std::function<Answer(const Job&, Error)>;

    Worker(WorkerSetup setup, Work work, Failed failed)
        : setup_(std::move(setup))
        , work_(std::move(work))
        , failed_(std::move(failed)) {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    /// Drops everything and waits for the current job.
    ~Worker() {
        {
            const std::scoped_lock lock(mutex_);
            ends_ = true;
            waiting_.clear();
            if (current_)
                dropCurrent();
        }
        arrived_.notify_one();
    }

    /// `progress` is reported until the work reports more; without it the job has no progress.
    void ask(Job job, std::optional<Progress> progress = {}) {
        {
            const std::scoped_lock lock(mutex_);
            if (setup_.order == JobOrder::NewestWins) {
                waiting_.clear();
                if (current_)
                    current_->superseded.request_stop();
            }
            waiting_.push_back({std::move(job), std::move(progress), setup_.stop});
        }
        if (hasThread())
            return arrived_.notify_one();
        std::unique_lock lock(mutex_);
        while (!waiting_.empty())
            doNext(lock, true);
    }

    /// Cancels waiting and current jobs for which `matches(job)` is true.
    template<class Matches>
    void drop(const Matches& matches) {
        {
            const std::scoped_lock lock(mutex_);
            std::erase_if(waiting_, [&](const Current& each) { return matches(each.job); });
            if (current_ && matches(current_->job))
                dropCurrent();
        }
        finished_.notify_all();
    }
    /// Drops answers that were not taken, for which `matches(answer)` is true.
    template<class Matches>
    void discard(const Matches& matches) {
        const std::scoped_lock lock(mutex_);
        std::erase_if(answers_, matches);
    }
    /// Cancels all jobs and drops all answers.
    void clear() {
        drop([](const Job&) { return true; });
        discard([](const Answer&) { return true; });
    }

    /// Returns the new answers, in order.
    [[nodiscard]] std::vector<Answer> take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(answers_, {});
    }
    /// Calls `look` with every answer that was not taken. Thread-safe.
    template<class Look>
    void look(const Look& look) const {
        const std::scoped_lock lock(mutex_);
        std::ranges::for_each(answers_, look);
    }

    /// The progress of the current job, or of the next one; empty if it has none.
    [[nodiscard]] std::optional<Progress> progress() const {
        const std::scoped_lock lock(mutex_);
        if (current_ && !current_->dropped && current_->progress)
            return current_->progress;
        const auto next =
            std::ranges::find_if(waiting_, [](const Current& each) { return each.progress.has_value(); });
        return next == waiting_.end() ? std::nullopt : next->progress;
    }

    /// Whether an answer is pending.
    [[nodiscard]] bool isWorking() const {
        const std::scoped_lock lock(mutex_);
        return isBusy(current_ && !current_->dropped);
    }
    /// Blocks until no answer is pending and `wake` was called for the last one.
    void wait() const {
        std::unique_lock lock(mutex_);
        finished_.wait(lock, [this] { return !isBusy(busy_ && !(current_ && current_->dropped)); });
    }

private:
    [[nodiscard]] bool isBusy(bool withCurrent) const { return withCurrent || !waiting_.empty(); }

    [[nodiscard]] bool hasThread() {
        if (setup_.when == When::WhenReady && !thread_.joinable()) {
            try {
                thread_ = std::jthread([this] { run(); });
            } catch (const std::system_error&) { // no thread available: slower, but it works
            }
        }
        return thread_.joinable();
    }

    void run() {
        std::unique_lock lock(mutex_);
        for (;;) {
            arrived_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
            if (ends_)
                return;
            doNext(lock, false);
        }
    }

    /// `lock` is held before and after, but not during the work.
    void doNext(std::unique_lock<std::mutex>& lock, bool atOnce) {
        current_ = std::move(waiting_.front());
        current_->atOnce = atOnce;
        waiting_.pop_front();
        busy_ = true;
        lock.unlock();
        std::optional<Answer> answer = answerOf(*current_);
        const bool news = answer && keep(*current_, std::move(*answer));
        answer.reset();
        lock.lock();
        std::optional<Current> done = std::exchange(current_, std::nullopt);
        lock.unlock();
        done.reset(); // freeing a large image takes time
        if (news)
            tell();
        lock.lock();
        busy_ = false;
        finished_.notify_all();
    }

    std::optional<Answer> answerOf(Current& current) {
        try {
            const Task task(*this, current);
            Result<std::optional<Answer>> answer = tried(setup_.words, [&] { return work_(task); });
            return answer ? std::move(*answer) : failed_(current.job, std::move(answer.error()));
        } catch (const std::bad_alloc&) { // no memory even for the message
            return std::nullopt;
        }
    }

    /// Whether the answer is wanted.
    bool keep(const Current& of, Answer answer) {
        const std::scoped_lock lock(mutex_);
        if (of.dropped)
            return false;
        if (setup_.order == JobOrder::NewestWins)
            answers_.clear();
        answers_.push_back(std::move(answer));
        return true;
    }

    void dropCurrent() {
        current_->dropped = true;
        current_->stop.request_stop();
        current_->superseded.request_stop();
    }

    void tell() const {
        if (setup_.wake)
            setup_.wake();
    }

    const WorkerSetup setup_;
    const Work work_;
    const Failed failed_;

    mutable std::mutex mutex_; // guards the members below
    std::condition_variable arrived_;
    mutable std::condition_variable finished_;
    std::deque<Current> waiting_;
    std::optional<Current> current_; ///< the working thread reads its job without the lock
    bool busy_ = false;              ///< with `current_` or what follows it
    bool ends_ = false;
    std::vector<Answer> answers_;

    std::jthread thread_; // last: it ends before the other members
};

} // namespace texplorer
