#include "texplorer/base/parallel.h"

#include <gtest/gtest.h>

#include <memory>

namespace texplorer::parallel_test {
namespace {

TEST(ParallelFor, CallsEachNumberOnce) {
    for (const unsigned threads : {0U, 1U, 2U, 16U})
        for (const std::size_t count : {0U, 1U, 5U, 1000U}) {
            const auto calls = std::make_unique<std::atomic<int>[]>(count);
            parallelFor(count, threads, [&](std::size_t i) { ++calls[i]; });
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_EQ(calls[i], 1) << i << " of " << count << " on " << threads;
        }
}

TEST(ParallelFor, UsesSeveralThreads) {
    std::atomic<int> waiting = 0;
    parallelFor(2, 2, [&](std::size_t) { // each waits for the other: one thread alone would never get out
        ++waiting;
        while (waiting < 2)
            std::this_thread::yield();
    });
    EXPECT_EQ(waiting, 2);
}

} // namespace
} // namespace texplorer::parallel_test
