// Google Benchmark's table, and below it every ratio that has a target. Each benchmark runs several times,
// all of them interleaved, and the median counts: what else the machine does then slows both sides of a
// ratio.

#include "tests/bench/comparisons.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <malloc.h>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::bench {
namespace {

class RatioReporter : public benchmark::ConsoleReporter {
public:
    RatioReporter()
        : ConsoleReporter(OO_None) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<Run> shown;
        for (const Run& run : runs) {
            const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
            if (run.error_occurred || median || run.repetitions == 1)
                shown.push_back(run);
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
            const auto peer = seconds_.find(row.peer);
            if (ours != seconds_.end() && peer != seconds_.end())
                print(row, ours->second, peer->second);
        }
        printSlowestLesson();
    }

private:
    /// The processor's time, which other programs hardly change; of what waits or has threads, the clock's.
    static double timeOf(const Run& run) {
        const std::string& type = run.run_name.time_type;
        const bool realTime = type == "real_time" || type == "manual_time";
        return realTime ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
    }

    static void print(const Comparison& row, double ours, double peer) {
        const bool faster = row.goal == Goal::FasterBy;
        const double ratio = faster ? peer / ours : ours / peer;
        const bool reached = faster ? ratio >= row.target : ratio <= row.target;
        std::printf("%s: %.2fx %s %s (target %s %gx)%s\n", row.name, ratio,
                    faster ? "as fast as" : "the time of", row.peerName, faster ? "at least" : "at most",
                    row.target, reached ? "" : "  MISSED");
    }

    void printSlowestLesson() const {
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
                        longest * 1000, goal * 1000, longest <= goal ? "" : "  MISSED");
    }

    std::map<std::string, double> seconds_;
};

} // namespace
} // namespace texplorer::bench

int main(int argc, char** argv) {
    // Freed memory stays with the program. Otherwise whether a picture of 16 MB is decoded into fresh pages,
    // which cost more than the decoding, would depend on what ran before.
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    // Defaults first: the same flags on the command line come later and win.
    std::string defaults[] = {"--benchmark_repetitions=5", "--benchmark_enable_random_interleaving=true",
                              "--benchmark_min_time=0.1"};
    std::vector<char*> arguments{argv[0]};
    for (std::string& each : defaults)
        arguments.push_back(each.data());
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
        return 2;
    texplorer::bench::RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return 0;
}
