#pragma once

#include <atomic>
#include <stop_token>
#include <string>

namespace texplorer::screenshot {

/// Work that may take long: Ctrl+C, SIGTERM or SIGHUP asks it to stop instead of ending the program half-way,
/// a second one ends the program at once, and after a second a terminal shows how far it is. There may be one
/// at a time.
class LongWork {
public:
    explicit LongWork(std::string what);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    [[nodiscard]] std::stop_token stopToken() const { return stop_.get_token(); }
    /// From any thread; `done` from 0 to 1.
    void report(float done);
    /// Wipes the terminal's line, so that a sentence may be said.
    void clearLine();
    /// The same; from here on nothing is reported, and Ctrl+C ends the program. Whether it
    /// came before is settled: stopToken knows it.
    void finish();

private:
    std::string what_;
    std::stop_source stop_;
    double start_;
    bool terminal_;
    std::atomic<int> shownPercent_ = -1;
};

} // namespace texplorer::screenshot
