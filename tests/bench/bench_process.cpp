// Whole processes, as a script that takes many screenshots pays for them.

#include <benchmark/benchmark.h>

#include <initializer_list>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <vector>

extern char** environ;

namespace {

/// Runs a program to its end, its output thrown away; false where it can't be started or fails.
bool run(std::initializer_list<std::string> words) {
    std::vector<std::string> copy(words);
    std::vector<char*> arguments;
    for (std::string& word : copy)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1 /* O_WRONLY */, 0);
    pid_t child = 0;
    const int failed = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    return failed == 0 && waitpid(child, &status, 0) == child && status == 0;
}

void runRepeatedly(benchmark::State& state, std::initializer_list<std::string> words) {
    for (auto _ : state) {
        if (!run(words)) {
            state.SkipWithError("the program failed");
            break;
        }
    }
}

#ifdef MINIMAL_OSMESA
void processMinimalOsmesa(benchmark::State& state) {
    runRepeatedly(state, {MINIMAL_OSMESA, "1280", "800"});
}
BENCHMARK(processMinimalOsmesa)->UseRealTime()->Unit(benchmark::kMillisecond);
#endif

void processTexshotShot(benchmark::State& state) {
    runRepeatedly(state, {TEXSHOT, "shot", "--size", "1280x800", "-o", "-"});
}
void processTexshotParams(benchmark::State& state) {
    runRepeatedly(state, {TEXSHOT, "params"});
}

BENCHMARK(processTexshotShot)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(processTexshotParams)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
