#pragma once

#include "tests/random/batches.h"
#include "tests/ui/workbench.h"

#include <gtest/gtest-spi.h>

namespace texplorer::random {

/// What is asserted while it lives fails no test and is kept.
struct CaughtFailures {
    testing::TestPartResultArray failures;
    testing::ScopedFakeTestPartResultReporter catching{
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ALL_THREADS, &failures};
};

/// A window that is tried in a child process: what its workbench asserts goes into the journal, as notes of
/// kind "broken".
class WindowTrial : private CaughtFailures, public test::Workbench {
protected:
    explicit WindowTrial(Journal& journal)
        : journal_(journal) {}
    ~WindowTrial() override {
        for (int i = 0; i < failures.size(); ++i)
            journal_.note("broken", failures.GetTestPartResult(i).message());
    }

    void step(std::string_view name) { journal_.step(name); }
    [[nodiscard]] bool hasFailed() const { return failures.size() > 0; }

private:
    void TestBody() override {}

    Journal& journal_;
};

} // namespace texplorer::random
