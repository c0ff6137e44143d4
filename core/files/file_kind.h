#pragma once

#include "texplorer/base/result.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <sys/stat.h>

namespace texplorer {

/// The kind of something that is not a regular file, as the end of a sentence: "is a directory".
[[nodiscard]] inline std::string_view kindName(mode_t mode) {
    if (S_ISDIR(mode))
        return N_("a directory");
    if (S_ISFIFO(mode))
        return N_("a pipe");
    if (S_ISSOCK(mode))
        return N_("a socket");
    if (S_ISLNK(mode))
        return N_("a link");
    return S_ISREG(mode) ? N_("a file") : N_("a device");
}

struct SystemText {
    int error;
    const char* text;
};
/// Those that users see and that can be translated; the words are POSIX's.
inline constexpr std::array systemTexts{
    SystemText{ENOENT, N_("No such file or directory")},
    SystemText{EACCES, N_("Permission denied")},
    SystemText{EPERM, N_("Operation not permitted")},
    SystemText{EISDIR, N_("Is a directory")},
    SystemText{ENOTDIR, N_("Not a directory")},
    SystemText{ENOSPC, N_("No space left on device")},
    SystemText{EDQUOT, N_("Disk quota exceeded")},
    SystemText{EROFS, N_("Read-only file system")},
    SystemText{ENAMETOOLONG, N_("File name too long")},
    SystemText{ELOOP, N_("Too many levels of symbolic links")},
    SystemText{EMFILE, N_("Too many open files")},
    SystemText{EIO, N_("Input/output error")},
};

/// The system's message for an errno: "No such file or directory".
[[nodiscard]] inline std::string systemText(int error) {
    const auto known = std::ranges::find(systemTexts, error, &SystemText::error);
    return known != systemTexts.end()
               ? known->text
               : std::strerror(error); // NOLINT: thread-safe in glibc for known numbers
}

} // namespace texplorer
