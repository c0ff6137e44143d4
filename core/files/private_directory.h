#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/files/descriptor.h"

#include <filesystem>

namespace texplorer {

/// A directory that only its user may read or change (mode 0700), held open: it stays the checked directory
/// even if its name changes.
class PrivateDirectory {
public:
    /// Errors: NotFound; it is a link or not a directory, belongs to another user, or is writable by others,
    /// who may have put files into it. Other users' read permission is removed.
    [[nodiscard]] static Result<PrivateDirectory> open(const std::filesystem::path& path);

    /// Like `open`; creates the directory and its parents if needed.
    [[nodiscard]] static Result<PrivateDirectory> make(const std::filesystem::path& path);

    [[nodiscard]] const Descriptor& descriptor() const { return directory_; }

    /// Opens a file of this user for reading; links are refused. Empty if there is none.
    [[nodiscard]] Descriptor openFile(const std::string& name) const;

private:
    explicit PrivateDirectory(Descriptor directory)
        : directory_(std::move(directory)) {}

    Descriptor directory_;
};

} // namespace texplorer
