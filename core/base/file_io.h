#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <string>

namespace texplorer {

inline constexpr std::size_t defaultMaxFileBytes = std::size_t{2} << 30;

/// Follows a long reading, on the thread that reads: asked before the first byte and after every few
/// megabytes. false stops it, with ErrorCode::Cancelled. `total` is the size that the file system states.
using ReadObserver = std::function<bool(std::size_t done, std::size_t total)>;

/// The whole file, in one read into an uninitialised buffer. Errors name the path: not found, a directory,
/// not readable, not a regular file, larger than `maxBytes` (then nothing is read).
[[nodiscard]] Result<Bytes> readFile(const std::filesystem::path& path,
                                     std::size_t maxBytes = defaultMaxFileBytes,
                                     const ReadObserver& observer = {});

/// The first bytes of a file, at most `count`: enough to see what it is. Errors as those of readFile.
[[nodiscard]] Result<Bytes> readFileStart(const std::filesystem::path& path, std::size_t count);

/// The same as text.
[[nodiscard]] Result<std::string> readText(const std::filesystem::path& path,
                                           std::size_t maxBytes = defaultMaxFileBytes);

/// Replaces the file as a whole or leaves it as it was: writes beside it, flushes, renames. A symbolic link
/// is followed, the permissions of an existing file are kept, and no partial file stays behind after a
/// failure.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, ByteView bytes);

[[nodiscard]] inline ByteView viewBytes(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

} // namespace texplorer
