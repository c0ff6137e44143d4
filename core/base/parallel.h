#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace texplorer {

/// How many threads this processor runs at once; at least 1.
[[nodiscard]] inline unsigned processorThreads() {
    return std::max(1U, std::thread::hardware_concurrency());
}

/// Calls work(i) once for every i below `count` and returns when all are done. Up to `threads` threads take
/// the next number as they get free; the calling thread is one of them. `work` must not throw. Where the
/// system gives fewer threads, fewer do it.
template<class Work>
void parallelFor(std::size_t count, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto takeNumbers = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::jthread> others; // joins before `next` and `takeNumbers` are gone
    try {
        for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i)
            others.emplace_back(takeNumbers);
    } catch (const std::system_error&) { // no more threads: those that there are will do
    }
    takeNumbers();
}

} // namespace texplorer
