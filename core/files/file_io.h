#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/files/descriptor.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace texplorer {

inline constexpr std::size_t defaultMaxFileBytes = std::size_t{2} << 30;

/// Progress of a long read, called on the reading thread: before the first byte and after every few
/// megabytes. Returning false stops the read with ErrorCode::Cancelled. `total` is the size that the file
/// system reports.
using ReadObserver = std::function<bool(std::size_t done, std::size_t total)>;

/// Reads the whole file in one read into an uninitialised buffer. Errors name the path: not found, a
/// directory, not readable, not a regular file, larger than `maxBytes` (then nothing is read).
[[nodiscard]] Result<Bytes> readFile(const std::filesystem::path& path,
                                     std::size_t maxBytes = defaultMaxFileBytes,
                                     const ReadObserver& observer = {});

/// Reads the first bytes of a file, at most `count`. Errors as of readFile.
[[nodiscard]] Result<Bytes> readFileStart(const std::filesystem::path& path, std::size_t count);

/// Like readFile, as text.
[[nodiscard]] Result<std::string> readText(const std::filesystem::path& path,
                                           std::size_t maxBytes = defaultMaxFileBytes);

/// Like readFile, for an open file. `file` may be empty after a failed open: errno must still hold the
/// reason.
[[nodiscard]] Result<Bytes> readOpened(const Descriptor& file, const std::string& where,
                                       std::size_t maxBytes = defaultMaxFileBytes);

/// Called when all bytes are on disk and no file has been replaced yet. If the program ends between this call
/// and the return, a temporary file may stay until the next write to that folder.
using BeforePlacing = std::function<void()>;

/// Whether to remove temporary files of killed programs from the folder. When many files are written into one
/// folder, once is enough.
enum class Leftovers : bool { Keep, Remove };

/// Replaces the whole file or leaves it unchanged: writes a nameless file, flushes it, and puts it in place.
/// Where the file system has no nameless files, a temporary name next to it is used. Follows symbolic links
/// and keeps the permissions of an existing file. No partial file stays after a failure. Temporary files of
/// killed programs are removed from the directory.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, ByteView bytes,
                                               const BeforePlacing& beforePlacing = {},
                                               Leftovers leftovers = Leftovers::Remove);

/// Called when all bytes are on disk, right before the file is replaced; returns whether it may be. Between
/// the call and the replacement, other programs' `writeFileIf` does not replace files in that folder.
using MayReplace = std::function<bool()>;

/// Like `writeFileAtomically`. Returns false if the file may not be replaced; it is then unchanged.
[[nodiscard]] Result<bool> writeFileIf(const std::filesystem::path& path, ByteView bytes,
                                       const MayReplace& mayReplace);

/// Like the above, in an open directory: `name` is not a path; a link of that name is replaced, never
/// followed. The permissions are 0600. Errors name `where`.
[[nodiscard]] Result<void> writeFileAtomically(const Descriptor& directory, const std::string& name,
                                               ByteView bytes, const std::string& where);

struct FileContent {
    std::string name; ///< in the folder or in a subfolder: "programs/demo.c"
    ByteView bytes;
};

/// Writes all files or none: every byte is on disk before the first file appears. Creates the folder, its
/// parents and the subfolders that the names need.
[[nodiscard]] Result<void> writeFolderAtomically(const std::filesystem::path& folder,
                                                 std::span<const FileContent> files,
                                                 const BeforePlacing& beforePlacing = {});

/// Checks whether the file can be written, for use before long work. Errors as of writing.
[[nodiscard]] Result<void> checkFileWritable(const std::filesystem::path& path);
[[nodiscard]] Result<void> checkFolderWritable(const std::filesystem::path& folder);

/// Writes all bytes to an open file. Returns false and leaves errno on failure.
[[nodiscard]] bool writeFully(int file, ByteView bytes);

[[nodiscard]] inline ByteView viewBytes(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

} // namespace texplorer
