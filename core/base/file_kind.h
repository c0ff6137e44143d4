#pragma once

#include "core/base/result.h"

#include <cstring>
#include <string>
#include <sys/stat.h>

namespace texplorer {

/// What something is that is no file, as the rest of a sentence: "is a directory".
[[nodiscard]] inline std::string_view kindName(mode_t mode) {
    if (S_ISDIR(mode))
        return "a directory";
    if (S_ISFIFO(mode))
        return "a pipe";
    if (S_ISSOCK(mode))
        return "a socket";
    if (S_ISLNK(mode))
        return "a link";
    return S_ISREG(mode) ? "a file" : "a device";
}

/// The system's words for an errno: "No such file or directory".
[[nodiscard]] inline std::string systemText(int error) {
    return std::strerror(error); // NOLINT: glibc's is safe for known numbers
}

} // namespace texplorer
