#include "app/screenshot/output/long_work.h"

#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/messages.h"

#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

LongWork::LongWork(std::string what)
    : what_(std::move(what))
    , start_(seconds())
    , terminal_(isatty(STDERR_FILENO) == 1 && !loudness().quiet) {
    askToStop(&stop_);
}

LongWork::~LongWork() {
    finish();
}

void LongWork::clearLine() {
    if (shownPercent_.exchange(-1) >= 0)
        std::fprintf(stderr, "\r\033[K");
}

void LongWork::finish() {
    askToStop(nullptr);
    clearLine();
    terminal_ = false;
}

void LongWork::report(float done) {
    if (!terminal_ || seconds() - start_ < 1)
        return;
    const int percent = static_cast<int>(done * 100);
    if (shownPercent_.exchange(percent) != percent)
        std::fprintf(stderr, "\r%s: %d %%", what_.c_str(), percent);
}

} // namespace texplorer::screenshot
