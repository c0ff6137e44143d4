#include "texplorer/base/background_thread.h"

#include <gtest/gtest.h>

#include <thread>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace texplorer::background_thread_test {
namespace {

#ifdef __linux__
int nicenessOfThisThread() {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
}

TEST(BackgroundThread, GivesWayWithThoseThatItStarts) {
    const int before = nicenessOfThisThread();
    int there = 0;
    int below = 0;
    std::thread([&] {
        giveWay();
        there = nicenessOfThisThread();
        std::thread([&] { below = nicenessOfThisThread(); }).join();
    }).join();
    EXPECT_GE(there, 10);
    EXPECT_EQ(below, there);
    EXPECT_EQ(nicenessOfThisThread(), before) << "the one that started it is what it was";
}
#endif

} // namespace
} // namespace texplorer::background_thread_test
