#pragma once

#include "texplorer/files/descriptor.h"

#include <chrono>
#include <filesystem>

namespace texplorer {

/// Locks a folder against other processes and threads that use the same lock: a file that is read, changed
/// and written under the lock loses no concurrent change. The folder itself is locked, so no lock file is
/// left.
class FolderLock {
public:
    /// Waits until the lock is free, at most `timeout`. After that, the caller continues without the lock.
    explicit FolderLock(const std::filesystem::path& folder,
                        std::chrono::milliseconds timeout = std::chrono::seconds(2));

    /// False if the folder or the file system does not support locks, or after the timeout.
    [[nodiscard]] bool isHeld() const { return isHeld_; }

private:
    Descriptor folder_;
    bool isHeld_ = false;
};

} // namespace texplorer
