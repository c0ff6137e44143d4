#pragma once

// Jobs that may end the process which does them, done by processes of their own.

#include "app/screenshot/workers/process.h"
#include "texplorer/base/result.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::workers {

struct Job {
    std::size_t number = 0; ///< the caller's, for the outcome
    std::string message;
    std::vector<std::string> environment{}; ///< that its process has to have, as StartCommand has it
    std::chrono::duration<double> limit = std::chrono::seconds(60); ///< after which it has hung
    std::uint64_t weight = 0; ///< of the memory that it takes: those that are done at once stay below a sum
    bool counts = true;       ///< for Outcome::before of those that follow
};

/// What became of a job.
struct Outcome {
    enum class End : std::uint8_t {
        Answered,
        Crashed, ///< the process ended, by a signal or by itself
        Hung,    ///< it took longer than its limit, and was killed
        Killed,  ///< somebody killed the process, twice: the system does so when memory runs out
        Garbled, ///< it sent what is no answer
    };
    std::size_t number = 0;
    End end = End::Answered;
    std::string answer{};    ///< of Answered
    int status = 0;          ///< of Crashed: as of waitpid(2)
    std::string lastWords{}; ///< what the process printed last, as it came; not of Answered
    std::size_t before = 0;  ///< how many jobs the same process had done before
    int attempt = 1;         ///< from 1
    std::chrono::duration<double> took{};
};

/// What became of it otherwise than by an answer, in a sentence: "the driver crashed: SIGSEGV, segmentation
/// fault". `who`: what had the process do it, "the driver".
[[nodiscard]] Sentence sentenceOf(const Outcome& outcome, std::string_view who);

struct PoolSetup {
    StartCommand command;
    unsigned processes = 1;
    std::uint64_t maxWeight = 0; ///< of the jobs that are done at once, if they are several; 0: no limit
    std::size_t maxJobs = 1000;  ///< that a process does before another one takes its place
    std::size_t maxResidentBytes = std::size_t{1536} << 20; ///< that a process may keep after a job
    std::stop_token stop{};
};

/// Gives the next job, or none: there will be no more. It is asked for one when a process is free to do it.
using JobSource = std::function<std::optional<Job>()>;
/// Called once for each job, in the order in which they end.
using JobSink = std::function<void(Outcome)>;

/// Has jobs done. What a job does to its process is that job's outcome, and another process takes its place;
/// a process that goes between two jobs takes none with it; one that was killed from outside in the middle of
/// a job is not held against the job until it happens again. Processes stay for the next `run`.
class Pool {
public:
    explicit Pool(PoolSetup setup);
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    /// Ends the processes; those that do something, by force.
    ~Pool();

    /// Errors: Cancelled after a stop request; processes that end whenever they are started.
    [[nodiscard]] Result<void> run(const JobSource& source, const JobSink& sink);

private:
    class Seats;
    std::unique_ptr<Seats> seats_;
};

} // namespace texplorer::workers
