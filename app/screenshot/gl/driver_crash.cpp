#include "app/screenshot/gl/driver_crash.h"

#include "app/screenshot/output/answer.h"
#include "app/screenshot/workers/signal_text.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

#ifdef TEXPLORER_SANITIZE
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

constexpr std::array crashSignals{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

/// Made beforehand: a signal's handler may do next to nothing.
struct Sentences {
    std::string own;
    std::string driver;
};
std::array<Sentences, crashSignals.size()> sentences;
std::atomic<bool> isDriverLoaded = false;

void endWithSentence(int signal) {
    for (std::size_t i = 0; i < crashSignals.size(); ++i) {
        if (crashSignals[i] != signal)
            continue;
        const std::string& text = isDriverLoaded ? sentences[i].driver : sentences[i].own;
        static_cast<void>(::write(STDERR_FILENO, text.data(), text.size()) > 0);
    }
    ::_exit(failure);
}

} // namespace

void sayCrashes() {
    if (isSanitized)
        return;
    // Of the main thread's own, as its stack may be what has run out.
    static std::array<char, 65536> stack;
    const stack_t other{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
    ::sigaltstack(&other, nullptr);
    for (std::size_t i = 0; i < crashSignals.size(); ++i) {
        const std::string what = workers::signalText(crashSignals[i]);
        sentences[i] = {
            fmt::format("texshot: it crashed: {}\n", what),
            fmt::format("texshot: OpenGL's driver crashed: {}; \"texshot drivers\" tries each, and "
                        "--renderer reference needs none\n",
                        what)};
        struct sigaction action {};
        action.sa_handler = endWithSentence;
        action.sa_flags = SA_ONSTACK;
        ::sigaction(crashSignals[i], &action, nullptr);
    }
}

void driverIsLoaded() {
    isDriverLoaded = true;
}

} // namespace texplorer::screenshot
