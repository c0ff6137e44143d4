#pragma once

// Standard output as a file that may be full or closed, or a pipe without a reader; and standard error.

#include "texplorer/files/file_io.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/text/printable.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer {

/// Whether the parent process wants an error for a pipe without a reader: it has SIGPIPE ignored.
inline bool& toldOfBrokenPipes() {
    static bool told = false;
    return told;
}

/// Call this first. Write errors are then reported by errno, not by a signal that ends the program. A closed
/// standard stream keeps its number, so that the next file does not get it.
inline void prepareStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) // opened so that its use fails, as for a closed stream
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    std::signal(SIGXFSZ, SIG_IGN);
    toldOfBrokenPipes() = std::signal(SIGPIPE, SIG_IGN) == SIG_IGN;
}

/// Writes everything or returns an error. On an error a file gets back its old length, because half a report
/// would look like a whole one. If the reader of a pipe is gone ("texshot schema | head -1"), the program
/// ends like others: by SIGPIPE, without a message.
[[nodiscard]] inline Result<void> writeStandardOutput(ByteView bytes) {
    // A file that is appended to (>>) starts at position 0.
    static const bool appends = (::fcntl(STDOUT_FILENO, F_GETFL) & O_APPEND) != 0;
    static const off_t start = ::lseek(STDOUT_FILENO, 0, appends ? SEEK_END : SEEK_CUR);
    if (writeFully(STDOUT_FILENO, bytes))
        return {};
    const int error = errno;
    struct stat info = {};
    if (start >= 0 && ::fstat(STDOUT_FILENO, &info) == 0 && S_ISREG(info.st_mode))
        static_cast<void>(::ftruncate(STDOUT_FILENO, start) == 0);
    if (error == EPIPE && !toldOfBrokenPipes()) {
        std::signal(SIGPIPE, SIG_DFL);
        std::raise(SIGPIPE);
    }
    return fail(ErrorCode::Unwritable, Sentence("can't be written: {0}", systemText(error)),
                inFile("standard output"));
}

/// Writes "program: sentence" to standard error.
inline void complain(const char* program, const std::string& sentence) {
    static_cast<void>(std::fprintf(stderr, "%s: %s\n", program, printable(sentence).c_str()));
}

} // namespace texplorer
