#pragma once

#include "texplorer/base/result.h"

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

/// The system's message for an errno: "No such file or directory".
[[nodiscard]] inline std::string systemText(int error) {
    return std::strerror(error); // NOLINT: thread-safe in glibc for known numbers
}

} // namespace texplorer
