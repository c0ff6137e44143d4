// Prints Google Benchmark's table, and below it every ratio that has a target. Each benchmark runs several
// times, all of them interleaved, and the median is used: other load on the machine then slows both sides of
// a ratio. Fails if a benchmark fails, or, without a filter, if a row of the table has no result. With --once
// each benchmark runs once, to check that all work and that peers draw the same pictures.

#include "tests/bench/comparisons.h"
#include "tests/bench/once.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <malloc.h>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::bench {
namespace {

class RatioReporter : public benchmark::ConsoleReporter {
public:
    explicit RatioReporter(bool filtered)
        : ConsoleReporter(OO_None)
        , filtered_(filtered) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<Run> shown;
        for (const Run& run : runs) {
            const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
            if (run.error_occurred || median || run.repetitions == 1)
                shown.push_back(run);
            if (run.error_occurred)
                failures_.insert(run.run_name.str() + ": " + run.error_message);
            if (!run.error_occurred && (median || run.repetitions == 1))
                seconds_[run.run_name.str()] = timeOf(run) / benchmark::GetTimeUnitMultiplier(run.time_unit);
        }
        if (!shown.empty())
            ConsoleReporter::ReportRuns(shown);
    }

    void Finalize() override {
        ConsoleReporter::Finalize();
        std::printf("\n");
        std::vector<Comparison> rows(comparisons.begin(), comparisons.end());
#ifdef DRIVER_FRAMES
        const std::vector<Comparison> frames = frameComparisons();
        rows.insert(rows.end(), frames.begin(), frames.end());
#endif
        for (const Comparison& row : rows) {
            const auto ours = seconds_.find(row.ours);
            const auto peer = row.peer ? seconds_.find(row.peer) : ours;
            if (ours != seconds_.end() && peer != seconds_.end())
                print(row, ours->second, peer->second);
            else if (!filtered_)
                failures_.insert(std::string(row.name) + ", " + row.peerName + ": there is no result");
        }
        printSlowestLesson();
        std::printf("%zu targets missed.\n", missed_);
        for (const std::string& failure : failures_)
            std::printf("FAILED %s\n", failure.c_str());
    }

    [[nodiscard]] bool failed() const {
        return !failures_.empty();
    }

private:
    /// Processor time, which other programs hardly affect; wall time for benchmarks that wait or use threads.
    static double timeOf(const Run& run) {
        const std::string& type = run.run_name.time_type;
        const bool realTime = type == "real_time" || type == "manual_time";
        return realTime ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
    }

    void print(const Comparison& row, double ours, double peer) {
        if (row.goal == Goal::TakesUpTo) {
            std::printf("%s: %.3g ms (target %s, at most %.3g ms)%s\n", row.name, ours * 1000, row.peerName,
                        row.target * 1000, verdict(ours <= row.target));
            return;
        }
        const bool faster = row.goal == Goal::FasterBy;
        const double ratio = faster ? peer / ours : ours / peer;
        std::printf("%s: %.2fx %s %s (target %s %gx)%s\n", row.name, ratio,
                    faster ? "as fast as" : "the time of", row.peerName, faster ? "at least" : "at most",
                    row.target, verdict(faster ? ratio >= row.target : ratio <= row.target));
    }

    const char* verdict(bool reached) {
        missed_ += reached ? 0 : 1;
        return reached ? "" : "  MISSED";
    }

    void printSlowestLesson() {
        constexpr std::string_view prefix = "lessonOpens/";
        constexpr double goal = 0.3;
        std::string slowest;
        double longest = 0;
        for (const auto& [name, seconds] : seconds_) {
            if (name.starts_with(prefix) && seconds > longest) {
                longest = seconds;
                slowest = name.substr(prefix.size(), name.find('/', prefix.size()) - prefix.size());
            }
        }
        if (longest > 0)
            std::printf("Slowest lesson to open: %s, %.0f ms (target at most %.0f ms)%s\n", slowest.c_str(),
                        longest * 1000, goal * 1000, verdict(longest <= goal));
    }

    bool filtered_;
    std::size_t missed_ = 0;
    std::map<std::string, double> seconds_;
    std::set<std::string> failures_; // a set: each repetition fails again
};

} // namespace
} // namespace texplorer::bench

int main(int argc, char** argv) {
    // Keeps freed memory in the program. Otherwise earlier benchmarks would decide whether a picture of 16 MB
    // is decoded into fresh pages, which cost more than the decoding.
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    const bool once = argc > 1 && std::strcmp(argv[1], "--once") == 0;
    texplorer::bench::onlyOnce = once;
    // Defaults first: the same flags on the command line come later and replace them.
    std::string defaults[] = {once ? "--benchmark_repetitions=1" : "--benchmark_repetitions=5",
                              once ? "--benchmark_min_time=0" : "--benchmark_min_time=0.1",
                              "--benchmark_enable_random_interleaving=true"};
    std::vector<char*> arguments{argv[0]};
    for (std::string& each : defaults)
        arguments.push_back(each.data());
    arguments.insert(arguments.end(), argv + (once ? 2 : 1), argv + argc);
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
        return 2;
    texplorer::bench::RatioReporter reporter(!benchmark::GetBenchmarkFilter().empty());
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return reporter.failed() ? 1 : 0;
}
