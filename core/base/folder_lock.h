#pragma once

#include "core/base/descriptor.h"

#include <chrono>
#include <filesystem>

namespace texplorer {

/// Keeps other processes, and other threads, that do the same out of a folder while it lives: who reads a
/// file there and writes it anew misses nobody's change. It is the folder itself that is locked: nothing is
/// left behind.
class FolderLock {
public:
    /// Waits until it is free, but no longer than `most`. Who must go on then does so without it.
    explicit FolderLock(const std::filesystem::path& folder,
                        std::chrono::milliseconds most = std::chrono::seconds(2));

    /// Not where the folder or the file system knows of no locks, or the wait was too long.
    [[nodiscard]] bool isHeld() const { return isHeld_; }

private:
    Descriptor folder_;
    bool isHeld_ = false;
};

} // namespace texplorer
