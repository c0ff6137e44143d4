#include "texplorer/files/folder_lock.h"

#include "texplorer/files/file_lock.h"

#include <cerrno>
#include <fcntl.h>
#include <thread>

namespace texplorer {

FolderLock::FolderLock(const std::filesystem::path& folder, std::chrono::milliseconds timeout)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (!folder_.valid())
        return;
    constexpr std::chrono::milliseconds pause(2);
    for (auto waited = std::chrono::milliseconds(0);; waited += pause) {
        const int error = lockFile(folder_.get());
        isHeld_ = error == 0;
        if (error != EWOULDBLOCK || waited >= timeout)
            return;
        std::this_thread::sleep_for(pause);
    }
}

} // namespace texplorer
