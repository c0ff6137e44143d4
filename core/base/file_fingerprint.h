#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace texplorer {

/// What tells one content of a file from another without reading it, and one file from another whatever it is
/// called: links and different spellings have the same.
struct FileFingerprint {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t bytes = 0;
    std::int64_t modifiedSeconds = 0;
    std::int64_t modifiedNanoseconds = 0;

    auto operator<=>(const FileFingerprint&) const = default; // NOLINT(modernize-use-nullptr): there is none
};

/// Nothing where there is no such file, or what is there is no regular one.
[[nodiscard]] std::optional<FileFingerprint> fingerprintOf(const std::filesystem::path& file);

} // namespace texplorer
