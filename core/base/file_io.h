#pragma once

#include "core/base/bytes.h"
#include "core/base/descriptor.h"
#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <span>
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

/// The same of a file that is open. `file` may be empty after a failed opening: errno is still its reason.
[[nodiscard]] Result<Bytes> readOpened(const Descriptor& file, const std::string& where,
                                       std::size_t maxBytes = defaultMaxFileBytes);

/// Called when all bytes are on the disk and nothing has taken its place yet: a program that ends between
/// this call and the return may leave a file under a temporary name, until the next writing there.
using BeforePlacing = std::function<void()>;

/// Whether what killed programs have left in a folder is looked for: of many files that are written into one,
/// with the first is enough.
enum class Leftovers : bool { Keep, Remove };

/// Replaces the file as a whole or leaves it as it was: writes a file without a name, flushes, puts it in its
/// place. Where the file system has no nameless files, a temporary name beside it does instead. A symbolic
/// link is followed, the permissions of an existing file are kept, and no partial file stays behind after a
/// failure. What programs that were killed have left in the directory is removed.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, ByteView bytes,
                                               const BeforePlacing& beforePlacing = {},
                                               Leftovers leftovers = Leftovers::Remove);

/// Asked when all bytes are on the disk, right before they take their place: whether they may. What other
/// programs write by `writeFileIf` isn't placed in that folder between the answer and the placing.
using MayReplace = std::function<bool()>;

/// As `writeFileAtomically`. false: it may not replace what is there now, which stays.
[[nodiscard]] Result<bool> writeFileIf(const std::filesystem::path& path, ByteView bytes,
                                       const MayReplace& mayReplace);

/// The same within a directory that is open: `name` is no path, a link of that name is replaced and never
/// followed. The permissions are 0600. Errors name `where`.
[[nodiscard]] Result<void> writeFileAtomically(const Descriptor& directory, const std::string& name,
                                               ByteView bytes, const std::string& where);

struct FileContent {
    std::string name; ///< within the folder, or in one of its own: "programs/demo.c"
    ByteView bytes;
};

/// Writes all of them, or none: every byte is on the disk before the first file appears. The folder is made
/// where it is missing, with what is above it and what the names lead to below it.
[[nodiscard]] Result<void> writeFolderAtomically(const std::filesystem::path& folder,
                                                 std::span<const FileContent> files,
                                                 const BeforePlacing& beforePlacing = {});

/// Whether the file could be written now, to know it before long work. Errors as those of the writing.
[[nodiscard]] Result<void> checkFileWritable(const std::filesystem::path& path);
[[nodiscard]] Result<void> checkFolderWritable(const std::filesystem::path& folder);

/// All the bytes into something that is open; false leaves errno.
[[nodiscard]] bool writeFully(int file, ByteView bytes);

[[nodiscard]] inline ByteView viewBytes(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

} // namespace texplorer
