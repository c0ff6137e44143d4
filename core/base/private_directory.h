#pragma once

#include "core/base/bytes.h"
#include "core/base/descriptor.h"
#include "core/base/result.h"

#include <filesystem>

namespace texplorer {

/// A directory that only its user may look into or change (mode 0700), held open: what it was found to be, it
/// stays, whatever becomes of its name.
class PrivateDirectory {
public:
    /// Errors: NotFound; it is a link or no directory, belongs to another user, or others may write to it, so
    /// that anybody's files may lie there. Others' right to read is taken away.
    [[nodiscard]] static Result<PrivateDirectory> open(const std::filesystem::path& path);

    /// The same, made where it is missing, with what is above it.
    [[nodiscard]] static Result<PrivateDirectory> make(const std::filesystem::path& path);

    [[nodiscard]] const Descriptor& descriptor() const { return directory_; }

    /// A file of this user for reading, no link; empty where there is none.
    [[nodiscard]] Descriptor openFile(const std::string& name) const;

private:
    explicit PrivateDirectory(Descriptor directory)
        : directory_(std::move(directory)) {}

    Descriptor directory_;
};

} // namespace texplorer
