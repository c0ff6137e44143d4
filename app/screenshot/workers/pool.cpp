#include "app/screenshot/workers/pool.h"

#include "app/screenshot/workers/signal_text.h"
#include "texplorer/base/sentence_format.h"

#include <algorithm>
#include <csignal>
#include <deque>
#include <list>
#include <memory>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/wait.h>
#include <thread>
#include <utility>

namespace texplorer::workers {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto maxWait = std::chrono::milliseconds(500); // until it is looked whether a process is gone
constexpr auto startLimit = std::chrono::seconds(60);    // until a process has begun with what it was given
constexpr auto patience = std::chrono::seconds(2);       // with processes that were told to end

} // namespace

class Pool::Seats {
public:
    explicit Seats(PoolSetup setup)
        : setup_(std::move(setup))
        , woken_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
    Seats(const Seats&) = delete;
    Seats& operator=(const Seats&) = delete;
    ~Seats();

    Result<void> run(const JobSource& source, const JobSink& sink);

private:
    /// A job with what has happened to it.
    struct Task {
        Job job;
        int kills = 0; ///< processes that were killed from outside while they did it
    };

    /// A process with what it does.
    struct Seat {
        Process process;
        std::vector<std::string> environment;
        std::size_t done = 0;
        std::size_t counted = 0; ///< of these
        std::optional<Task> task{};
        bool begun = false;
        bool silent = false; ///< it will say nothing more
        Clock::time_point since{};
        Clock::time_point deadline{};
    };

    [[nodiscard]] const Task* next();
    [[nodiscard]] bool hasRoom() const;
    [[nodiscard]] bool fits(const Job& job) const;
    [[nodiscard]] Result<void> handOut();
    [[nodiscard]] Result<std::size_t> seatFor(const Job& job);
    void wait();
    void look(Seat& seat, bool answered);
    void checkTime();
    [[nodiscard]] bool isOver(Seat& seat);
    void takeAnswer(Seat& seat, std::string answer);
    void end(Seat& seat, Outcome::End end);
    void leave(Seat& seat);

    PoolSetup setup_;
    const JobSource* source_ = nullptr;
    const JobSink* sink_ = nullptr;
    Descriptor woken_; ///< by a stop request
    std::deque<Task> waiting_;
    bool sourceIsEmpty_ = false;
    std::vector<std::unique_ptr<Seat>> seats_;
    std::list<Process> leaving_; ///< on their way out
    unsigned failedStarts_ = 0;  ///< one after the other
    std::string failedWords_;
    Clock::time_point looked_{};
};

/// What is to be done next, if anything.
auto Pool::Seats::next() -> const Task* {
    if (waiting_.empty() && !sourceIsEmpty_) {
        if (std::optional<Job> job = (*source_)())
            waiting_.push_back({std::move(*job)});
        else
            sourceIsEmpty_ = true;
    }
    return waiting_.empty() ? nullptr : &waiting_.front();
}

/// Beside what is being done.
bool Pool::Seats::fits(const Job& job) const {
    std::uint64_t sum = 0;
    bool any = false;
    for (const auto& seat : seats_) {
        if (seat->task) {
            sum += seat->task->job.weight;
            any = true;
        }
    }
    return !any || setup_.maxWeight == 0 || sum + job.weight <= setup_.maxWeight;
}

bool Pool::Seats::hasRoom() const {
    return seats_.size() < setup_.processes ||
           std::ranges::any_of(seats_, [](const auto& seat) { return !seat->task; });
}

/// A process that is free and has the job's environment, which may be a new one; the number of seats where
/// all are taken.
Result<std::size_t> Pool::Seats::seatFor(const Job& job) {
    const auto at = [this](auto found) { return static_cast<std::size_t>(found - seats_.begin()); };
    const auto free = std::ranges::find_if(
        seats_, [&job](const auto& seat) { return !seat->task && seat->environment == job.environment; });
    if (free != seats_.end())
        return at(free);
    const auto other = std::ranges::find_if(seats_, [](const auto& seat) { return !seat->task; });
    if (other != seats_.end()) {
        leave(**other);
        seats_.erase(other);
    }
    if (seats_.size() >= setup_.processes)
        return seats_.size();
    StartCommand command = setup_.command;
    command.environment.insert(command.environment.end(), job.environment.begin(), job.environment.end());
    Result<Process> process = Process::start(command);
    const bool busy = std::ranges::any_of(seats_, [](const auto& seat) { return seat->task.has_value(); });
    if (!process && !busy)
        return fail(process.error());
    if (!process) // as many as there are will do
        return seats_.size();
    seats_.push_back(std::make_unique<Seat>(Seat{std::move(*process), job.environment}));
    return seats_.size() - 1;
}

Result<void> Pool::Seats::handOut() {
    while (hasRoom()) {
        const Task* task = next();
        if (task == nullptr || !fits(task->job))
            return {};
        if (failedStarts_ >= 3 + 3 * setup_.processes) // somebody may have killed all of them at once
            return fail(ErrorCode::Driver,
                        failedWords_.empty()
                            ? Sentence(N_("worker processes end immediately"))
                            : Sentence("worker processes end immediately; the last one printed: {0}",
                                       ProperName{failedWords_}));
        const Result<std::size_t> at = seatFor(task->job);
        if (!at)
            return fail(at.error());
        if (*at == seats_.size())
            return {};
        Seat& seat = *seats_[*at];
        seat.task = std::move(waiting_.front());
        waiting_.pop_front();
        seat.begun = false;
        seat.since = Clock::now();
        seat.deadline = seat.since + startLimit;
        seat.process.forgetWords();
        seat.process.send(Kind::Job, seat.task->job.message);
    }
    return {};
}

/// Until a process has something to say, or it is time to look.
void Pool::Seats::wait() {
    std::vector<pollfd> files{{woken_.get(), POLLIN, 0}};
    Clock::time_point until = Clock::now() + maxWait;
    for (const auto& seat : seats_) {
        const Process& process = seat->process;
        const int wanted = POLLIN | (process.hasMoreToSend() ? POLLOUT : 0);
        files.push_back({seat->silent ? -1 : process.socket(), static_cast<short>(wanted), 0});
        files.push_back({process.output(), POLLIN, 0}); // negative once it is closed: left out
        if (seat->task)
            until = std::min(until, seat->deadline);
        if (seat->silent)
            until = std::min(until, Clock::now() + std::chrono::milliseconds(5));
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    static_cast<void>(
        ::poll(files.data(), files.size(), static_cast<int>(std::max<std::int64_t>(left.count(), 0))));
    std::vector<std::pair<Seat*, bool>> spoke;
    for (std::size_t i = 0; i < seats_.size(); ++i) {
        const pollfd& socket = files[1 + 2 * i];
        const pollfd& output = files[2 + 2 * i];
        if ((socket.revents & POLLOUT) != 0)
            seats_[i]->process.sendMore();
        if (output.revents != 0)
            seats_[i]->process.listen();
        spoke.emplace_back(seats_[i].get(), (socket.revents & ~POLLOUT) != 0);
    }
    for (const auto& [seat, answered] : spoke)
        look(*seat, answered);
    std::erase_if(seats_, [this](const auto& seat) { return isOver(*seat); });
}

/// What a process has to say, and whether it is still there.
void Pool::Seats::look(Seat& seat, bool answered) {
    const bool open = !answered || seat.process.read();
    bool nonsense = false;
    while (std::optional<Message> message = seat.process.take()) {
        if (message->kind == Kind::Begun && seat.task) {
            seat.begun = true;
            seat.since = Clock::now();
            seat.deadline = seat.since + std::chrono::ceil<Clock::duration>(seat.task->job.limit);
            failedStarts_ = 0;
        } else if (message->kind == Kind::Answer && seat.task && seat.begun) {
            takeAnswer(seat, std::move(message->text));
        } else {
            nonsense = true;
        }
    }
    if (nonsense || seat.process.talksNonsense())
        end(seat, Outcome::End::Garbled);
    if (nonsense || seat.process.talksNonsense() || !open) {
        seat.silent = true;
        seat.process.kill(); // where it isn't gone yet
    }
}

/// Whether the process is gone, or was told to go; then its task is settled.
bool Pool::Seats::isOver(Seat& seat) {
    if (seat.process.status()) {
        while (!seat.silent) // an answer may have come before the end
            look(seat, true);
        seat.process.listen();
        end(seat, Outcome::End::Crashed);
        return true;
    }
    if (seat.task)
        return false;
    if (!seat.silent && seat.done < setup_.maxJobs &&
        (seat.done == 0 || seat.process.residentBytes() <= setup_.maxResidentBytes))
        return false;
    leave(seat);
    return true;
}

void Pool::Seats::takeAnswer(Seat& seat, std::string answer) {
    const Task task = *std::exchange(seat.task, std::nullopt);
    const std::size_t before = seat.counted;
    ++seat.done;
    seat.counted += task.job.counts ? 1 : 0;
    (*sink_)({.number = task.job.number,
              .answer = std::move(answer),
              .before = before,
              .attempt = task.kills + 1,
              .took = Clock::now() - seat.since});
}

/// Of a process that has a task and is gone, or as good as that.
void Pool::Seats::end(Seat& seat, Outcome::End end) {
    if (!seat.task)
        return;
    Task task = *std::exchange(seat.task, std::nullopt);
    const int status = seat.process.status().value_or(0);
    if (!seat.begun) { // it never saw the job
        ++failedStarts_;
        failedWords_ = seat.process.lastWords();
        waiting_.push_front(std::move(task));
        return;
    }
    if (end == Outcome::End::Crashed && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
        if (++task.kills < 2) {
            waiting_.push_front(std::move(task));
            return;
        }
        end = Outcome::End::Killed;
    }
    (*sink_)({.number = task.job.number,
              .end = end,
              .status = status,
              .lastWords = seat.process.lastWords(),
              .before = seat.counted,
              .attempt = task.kills + (end == Outcome::End::Killed ? 0 : 1),
              .took = end == Outcome::End::Hung ? task.job.limit : Clock::now() - seat.since});
}

void Pool::Seats::checkTime() {
    // Whoever stops this process (Ctrl+Z, a debugger, a machine that sleeps) may have stopped the others,
    // too.
    const Clock::time_point now = Clock::now();
    const auto late = now - looked_ - maxWait;
    if (late > std::chrono::seconds(2)) {
        for (const auto& seat : seats_)
            seat->deadline += late;
    }
    looked_ = now;
    std::erase_if(seats_, [this, now](const auto& seat) {
        if (!seat->task || now < seat->deadline)
            return false;
        seat->process.kill();
        seat->process.listen();
        end(*seat, Outcome::End::Hung);
        leaving_.push_back(std::move(seat->process));
        return true;
    });
}

void Pool::Seats::leave(Seat& seat) {
    seat.process.dismiss();
    leaving_.push_back(std::move(seat.process));
}

Pool::Seats::~Seats() {
    for (const auto& seat : seats_) {
        if (seat->task)
            seat->process.kill();
        leave(*seat);
    }
    const Clock::time_point until = Clock::now() + patience;
    for (;;) {
        std::erase_if(leaving_, [](Process& each) { return each.status().has_value(); });
        if (leaving_.empty() || Clock::now() > until) // those that are left are killed now
            return;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

Result<void> Pool::Seats::run(const JobSource& source, const JobSink& sink) {
    source_ = &source;
    sink_ = &sink;
    sourceIsEmpty_ = false;
    looked_ = Clock::now();
    const std::stop_callback wake(setup_.stop, [this] {
        const std::uint64_t one = 1;
        static_cast<void>(::write(woken_.get(), &one, sizeof one) == sizeof one);
    });
    for (;;) {
        if (setup_.stop.stop_requested())
            return fail(ErrorCode::Cancelled, "interrupted");
        if (const Result<void> handed = handOut(); !handed)
            return handed;
        if (std::ranges::none_of(seats_, [](const auto& seat) { return seat->task.has_value(); }))
            return {};
        wait();
        checkTime();
        std::erase_if(leaving_, [](Process& each) { return each.status().has_value(); });
    }
}

Sentence sentenceOf(const Outcome& outcome, std::string_view who) {
    Sentence text;
    switch (outcome.end) {
    case Outcome::End::Answered:
        return {};
    case Outcome::End::Crashed:
        text = WIFSIGNALED(outcome.status)
                   ? Sentence("{0} crashed: {1}", who, signalText(WTERMSIG(outcome.status)))
                   : Sentence("{0} ended the process, with status {1}", who, WEXITSTATUS(outcome.status));
        break;
    case Outcome::End::Hung:
        text =
            Sentence("no answer within {0:.3g} s: {1} hangs, or needs more time", outcome.took.count(), who);
        break;
    case Outcome::End::Killed:
        text = N_(
            "the process was killed, and so was a second one: SIGKILL, as the system does when memory runs "
            "out");
        break;
    case Outcome::End::Garbled:
        text = N_("the process sent an invalid answer: its memory was overwritten");
        break;
    }
    if (outcome.before > 0)
        text = Sentence("{0} (after {1} in the same process)", text,
                        Sentence::plural("{0} other case", "{0} other cases", outcome.before));
    return text;
}

Pool::Pool(PoolSetup setup)
    : seats_(std::make_unique<Seats>(std::move(setup))) {}

Pool::~Pool() = default;

Result<void> Pool::run(const JobSource& source, const JobSink& sink) {
    return seats_->run(source, sink);
}

} // namespace texplorer::workers
