#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <pthread.h>

namespace texplorer::test {

/// As long as it lives the system gives no new threads: each would need a stack that fits nowhere.
class NoThreads {
public:
#ifdef __wasm__
    NoThreads() {} // there are none
#else
    NoThreads() {
        EXPECT_EQ(::pthread_getattr_default_np(&before_), 0);
        pthread_attr_t huge;
        EXPECT_EQ(::pthread_attr_init(&huge), 0);
        EXPECT_EQ(::pthread_attr_setstacksize(&huge, std::numeric_limits<std::size_t>::max() / 16 * 15), 0);
        EXPECT_EQ(::pthread_setattr_default_np(&huge), 0);
        ::pthread_attr_destroy(&huge);
    }
    ~NoThreads() {
        EXPECT_EQ(::pthread_setattr_default_np(&before_), 0);
        ::pthread_attr_destroy(&before_);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    pthread_attr_t before_{};
#endif
};

} // namespace texplorer::test
