#include "app/screenshot/runs/run_progress.h"

#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <cstdio>
#include <unistd.h>

namespace texplorer::screenshot {

RunProgress::RunProgress(Says says, std::size_t cases)
    : says_(says == Says::OneLine && ::isatty(STDERR_FILENO) != 1 ? Says::Nothing : says)
    , cases_(cases) {}

void RunProgress::add(const suite::CaseRecord& record) {
    ++done_;
    if (suite::rowOf(record.state).status != 0)
        ++failed_;
    if (says_ == Says::EveryCase)
        std::fputs(fmt::format("{}/{} {} in {:.2f} s: {}\n", done_, cases_, suite::rowOf(record.state).text,
                               record.seconds, printable(record.name))
                       .c_str(),
                   stderr);
    if (says_ != Says::OneLine)
        return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) // a terminal is slower than the cases may be
        return;
    last_ = now;
    shown_ = true;
    const std::string failures = failed_ == 0 ? std::string() : fmt::format(", {} not alike", failed_);
    std::fputs(fmt::format("\r\033[Ktexshot: {} of {}{}", done_, cases_, failures).c_str(), stderr);
    std::fflush(stderr);
}

void RunProgress::clear() {
    if (shown_)
        std::fputs("\r\033[K", stderr);
    shown_ = false;
}

} // namespace texplorer::screenshot
