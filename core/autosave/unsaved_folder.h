#pragma once

// Where drafts lie: a directory with a file for each window that has unsaved work, and a lock beside it.

#include "core/autosave/unsaved_scene.h"
#include "core/base/descriptor.h"

#include <chrono>
#include <vector>

namespace texplorer {

/// $XDG_STATE_HOME/texplorer/unsaved, else ~/.local/state/texplorer/unsaved; empty where neither is known.
[[nodiscard]] std::filesystem::path unsavedFolderOfUser();

/// A place for one draft, held by an advisory lock (flock) as long as this object or its process lives: a
/// draft whose lock nobody holds belongs to a window that has died. Move-only, safe when empty.
class UnsavedPlace {
public:
    UnsavedPlace() = default;
    UnsavedPlace(const UnsavedPlace&) = delete;
    UnsavedPlace& operator=(const UnsavedPlace&) = delete;
    UnsavedPlace(UnsavedPlace&&) noexcept = default;
    UnsavedPlace& operator=(UnsavedPlace&& other) noexcept;
    /// Lets go of the lock. A draft that was written stays; where there is none, nothing stays.
    ~UnsavedPlace() { release(); }

    /// A place of this process's own. The directory is made with mode 0700 where it isn't there. Errors: it
    /// can't be made or written, is somebody else's, or knows no locks.
    [[nodiscard]] static Result<UnsavedPlace> create(const std::filesystem::path& folder);

    [[nodiscard]] bool isOpen() const { return lock_.valid(); }
    [[nodiscard]] const std::filesystem::path& draft() const { return draft_; }

    /// Replaces the draft as a whole, and flushes it to the disk.
    [[nodiscard]] Result<void> write(const UnsavedScene& draft) const;
    [[nodiscard]] Result<UnsavedScene> read() const;
    void remove() const; ///< the draft, if there is one

private:
    friend std::vector<struct Orphan> claimOrphans(const std::filesystem::path& folder);
    enum class Make { New, Any };
    /// NotFound: another process holds it, or has swept it away.
    [[nodiscard]] static Result<UnsavedPlace> lock(const std::filesystem::path& draft, Make make);
    void release();

    std::filesystem::path draft_;
    Descriptor lock_;
};

/// A draft whose window has died.
struct Orphan {
    Result<UnsavedPlace> place; ///< the error: its lock can't be opened or taken, and nobody else holds it
    std::filesystem::file_time_type written;
};

/// Every orphan, the youngest first, at most 32; no other process is given them as long as these objects
/// live. Locks without a draft are swept away. Empty where there is no such directory,
/// or others may write to it.
[[nodiscard]] std::vector<Orphan> claimOrphans(const std::filesystem::path& folder);

} // namespace texplorer
