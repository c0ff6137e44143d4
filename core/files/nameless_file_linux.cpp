#include "texplorer/files/nameless_file.h"

#include <fmt/core.h>

#include <fcntl.h>

namespace texplorer {

Descriptor openNameless(int directory, mode_t mode) {
    return Descriptor(::openat(directory, ".", O_WRONLY | O_TMPFILE | O_CLOEXEC, mode));
}

bool nameFile(int file, int directory, const std::string& name) {
    // This way needs /proc and no privilege.
    const std::string self = fmt::format("/proc/self/fd/{}", file);
    return ::linkat(AT_FDCWD, self.c_str(), directory, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

} // namespace texplorer
