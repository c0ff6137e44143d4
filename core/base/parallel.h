#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace texplorer {

/// The number of threads that the processor runs at once; at least 1.
[[nodiscard]] inline unsigned processorThreads() {
    return std::max(1U, std::thread::hardware_concurrency());
}

/// Calls work(i) once for each i below `count` and returns when all calls are done. Up to `threads` threads,
/// including the caller, take the next number when they are free; fewer if the system refuses threads. `work`
/// must not throw.
template<class Work>
void parallelFor(std::size_t count, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto takeNumbers = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::jthread> others; // joined before `next` and `takeNumbers` are destroyed
    try {
        for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i)
            others.emplace_back(takeNumbers);
    } catch (const std::system_error&) { // no more threads: continue with the existing ones
    }
    takeNumbers();
}

} // namespace texplorer
