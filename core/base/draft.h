#pragma once

#include "core/base/bytes.h"
#include "core/base/descriptor.h"

#include <string>
#include <sys/stat.h>

namespace texplorer {

/// A new file that is not in its place yet, and goes away unless it takes it. Functions that fail return
/// false and leave errno.
class Draft {
public:
    /// In a directory that stays open longer than the draft.
    explicit Draft(int directory, mode_t mode = 0666);
    Draft(Draft&&) = default;
    Draft& operator=(Draft&&) = delete;
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft();

    [[nodiscard]] bool valid() const { return file_.valid(); }

    /// The whole content, down to the disk, with the owner and permissions of the file that it will replace.
    /// `bytes` must live as long as the draft.
    [[nodiscard]] bool write(ByteView bytes, const struct stat* replaced = nullptr);

    /// Under this name, in place of whatever file or link has it, in the same file system.
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
    std::string temporary_; ///< its name for the time being; empty: none
};

/// Removes the drafts that programs which were killed left in a directory: regular files of this user, under
/// a draft's name, that nobody holds a lock on.
void sweepDrafts(int directory);

} // namespace texplorer
