#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/files/descriptor.h"

#include <string>
#include <sys/stat.h>

namespace texplorer {

/// A new file that is not in its place yet. The destructor removes it unless `place` succeeded. Functions
/// that fail return false and leave errno.
class Draft {
public:
    /// Creates the file in an open directory, which must outlive the draft.
    explicit Draft(int directory, mode_t mode = 0666);
    Draft(Draft&&) = default;
    Draft& operator=(Draft&&) = delete;
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft();

    [[nodiscard]] bool valid() const { return file_.valid(); }

    /// Writes the whole content and flushes it to disk, with the owner and permissions of the file that it
    /// will replace. `bytes` must outlive the draft.
    [[nodiscard]] bool write(ByteView bytes, const struct stat* replaced = nullptr);

    /// Gives the file this name, replacing any file or link of that name, in the same file system.
    [[nodiscard]] bool place(int directory, const std::string& name);

private:
    [[nodiscard]] bool openNamed();
    [[nodiscard]] bool fill();
    [[nodiscard]] bool takeTemporaryName();

    int directory_;
    mode_t mode_;
    Descriptor file_;
    ByteView bytes_;
    const struct stat* replaced_ = nullptr;
    std::string temporary_; ///< its temporary name; empty: none
};

/// Removes the drafts of killed programs from a directory: regular files of this user, with the name of a
/// draft, without a lock.
void sweepDrafts(int directory);

} // namespace texplorer
