#pragma once

// Standard output as a file that may be full, closed or a pipe that nobody reads.

#include "core/base/file_io.h"
#include "core/base/file_kind.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer {

/// Whether whoever started the program wants to be told of a pipe that nobody reads: it has SIGPIPE ignored.
inline bool& toldOfBrokenPipes() {
    static bool told = false;
    return told;
}

/// Called first. What can't be written is then told by errno, not by a signal that ends the program; and a
/// standard stream that is closed is not the number that the next file gets.
inline void prepareStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) // opened so that its use fails, as of a closed one
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    std::signal(SIGXFSZ, SIG_IGN);
    toldOfBrokenPipes() = std::signal(SIGPIPE, SIG_IGN) == SIG_IGN;
}

/// All of it, or an error. Of what was written to a file nothing is left then: half a report would look like
/// a whole one. What was there before stays. Where nobody reads any more ("texshot schema | head -1"), the
/// program ends as others do, by SIGPIPE and without a word.
[[nodiscard]] inline Result<void> writeStandardOutput(ByteView bytes) {
    // A file that is appended to (>>) is opened at its beginning.
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
    return fail(ErrorCode::Unwritable, "can't be written: " + systemText(error), "standard output");
}

} // namespace texplorer
