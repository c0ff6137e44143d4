#include "app/screenshot/workers/signal_text.h"

#include <gtest/gtest.h>

#include <csignal>

namespace texplorer::workers::signal_text_test {
namespace {

TEST(SignalText, SaysNameAndMeaning) {
    EXPECT_EQ(signalText(SIGSEGV), "SIGSEGV, segmentation fault");
    EXPECT_EQ(signalText(SIGKILL), "SIGKILL, killed");
    EXPECT_EQ(signalText(4711), "signal 4711");
}

} // namespace
} // namespace texplorer::workers::signal_text_test
