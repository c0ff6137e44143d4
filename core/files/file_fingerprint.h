#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace texplorer {

/// Identifies a file and a version of its content without reading it. Links and other spellings of a path
/// have the same fingerprint.
struct FileFingerprint {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t bytes = 0;
    std::int64_t modifiedSeconds = 0;
    std::int64_t modifiedNanoseconds = 0;

    auto operator<=>(const FileFingerprint&) const = default; // NOLINT(modernize-use-nullptr): false positive
};

/// Empty where the file does not exist or is not regular.
[[nodiscard]] std::optional<FileFingerprint> fingerprintOf(const std::filesystem::path& file);

} // namespace texplorer
