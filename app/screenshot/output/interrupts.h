#pragma once

#include "app/screenshot/output/answer.h"

#include <mutex>
#include <stop_token>
#include <string>

namespace texplorer::screenshot {

/// From here on Ctrl+C, SIGTERM and SIGHUP end the program with a sentence, the document that is expected
/// (answer.h) and, as a shell has it, 128 and the signal's number; a signal that is ignored stays so (nohup).
/// Called once, before there is another thread.
void watchInterrupts();

/// From here on they do nothing. Called last: objects are then destroyed that ending the program would use.
void ignoreInterrupts();

/// Whom a signal asks to stop instead of ending the program; a second one ends it. nullptr: nobody.
void askToStop(std::stop_source* work);

/// While it lives a signal asks this one.
class AskedToStop {
public:
    explicit AskedToStop(std::stop_source& work) { askToStop(&work); }
    AskedToStop(const AskedToStop&) = delete;
    AskedToStop& operator=(const AskedToStop&) = delete;
    ~AskedToStop() { askToStop(nullptr); }
};

/// What is said after the work was stopped, and the exit status of its signal. `written`: "3 of 8 pictures
/// were written"; empty: that nothing was, if so.
ExitCode complainInterrupted(const Sentence& written = {});

/// From here on the sentence doesn't say that nothing was written.
void outputBegins();

/// While it lives no signal ends the program: an output is taking its place.
class Uninterrupted {
public:
    Uninterrupted();

private:
    std::unique_lock<std::recursive_mutex> lock_;
};

/// While it lives standard output is written: a signal ends the program after that, or when it takes too
/// long.
class Printing {
public:
    Printing();

private:
    std::unique_lock<std::timed_mutex> lock_;
};

/// Whether something was printed, or will be: standard output has its document.
[[nodiscard]] bool hasPrinted();

} // namespace texplorer::screenshot
