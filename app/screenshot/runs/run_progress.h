#pragma once

#include "texplorer/suite/record.h"

#include <chrono>
#include <cstddef>

namespace texplorer::screenshot {

/// How a run goes on, on standard error: on a terminal one line that changes; or a line for each case.
class RunProgress {
public:
    enum class Says : std::uint8_t { Nothing, OneLine, EveryCase };

    RunProgress(Says says, std::size_t cases);
    RunProgress(const RunProgress&) = delete;
    RunProgress& operator=(const RunProgress&) = delete;
    ~RunProgress() { clear(); }

    void add(const suite::CaseRecord& record);
    /// Wipes the line, for whatever is said next.
    void clear();

private:
    Says says_;
    std::size_t cases_;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_{};
};

} // namespace texplorer::screenshot
