#include "texplorer/files/file_fingerprint.h"

#include <sys/stat.h>

namespace texplorer {

std::optional<FileFingerprint> fingerprintOf(const std::filesystem::path& file) {
    struct stat info = {};
    if (::stat(file.c_str(), &info) != 0 || !S_ISREG(info.st_mode))
        return std::nullopt;
    return FileFingerprint{info.st_dev, info.st_ino, info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec};
}

} // namespace texplorer
