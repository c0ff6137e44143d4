#pragma once

// The directory of drafts: a file for each window with unsaved work, each with a lock file next to it.

#include "texplorer/files/descriptor.h"
#include "texplorer/scene/storage/unsaved_scene.h"

#include <chrono>
#include <vector>

namespace texplorer {

/// Returns $XDG_STATE_HOME/texplorer/unsaved, else ~/.local/state/texplorer/unsaved. Empty where neither is
/// known.
[[nodiscard]] std::filesystem::path unsavedFolderOfUser();

/// The place of one draft. It is held by an advisory lock (flock) until this object or its process ends: an
/// unlocked draft belongs to a window that has crashed. Move-only; may be empty.
class UnsavedPlace {
public:
    UnsavedPlace() = default;
    UnsavedPlace(const UnsavedPlace&) = delete;
    UnsavedPlace& operator=(const UnsavedPlace&) = delete;
    UnsavedPlace(UnsavedPlace&&) noexcept = default;
    UnsavedPlace& operator=(UnsavedPlace&& other) noexcept;
    /// Releases the lock. A written draft stays; without one, no file stays.
    ~UnsavedPlace() { release(); }

    /// Creates a new place for this process. The directory is created with mode 0700 if it does not exist.
    /// Errors: it cannot be created or written, belongs to another user, or does not support locks.
    [[nodiscard]] static Result<UnsavedPlace> create(const std::filesystem::path& folder);

    [[nodiscard]] bool isOpen() const { return lock_.valid(); }
    [[nodiscard]] const std::filesystem::path& draft() const { return draft_; }

    /// Replaces the whole draft and flushes it to disk.
    [[nodiscard]] Result<void> write(const UnsavedScene& draft) const;
    [[nodiscard]] Result<UnsavedScene> read() const;
    void remove() const; ///< removes the draft, if there is one

private:
    friend std::vector<struct Orphan> claimOrphans(const std::filesystem::path& folder);
    enum class Make { New, Any };
    /// Locks an existing draft. NotFound: another process holds it or has removed it.
    [[nodiscard]] static Result<UnsavedPlace> lock(const std::filesystem::path& draft, Make make);
    void release();

    std::filesystem::path draft_;
    Descriptor lock_;
};

/// A draft of a window that has crashed.
struct Orphan {
    Result<UnsavedPlace>
        place; ///< the error: its lock cannot be opened or taken, and no other process holds it
    std::filesystem::file_time_type written;
};

/// Locks and returns all orphans, newest first, at most 32. Other processes do not get them while these
/// objects live. Locks without a draft are removed. Empty where the directory does not exist or other users
/// may write to it.
[[nodiscard]] std::vector<Orphan> claimOrphans(const std::filesystem::path& folder);

} // namespace texplorer
