#pragma once

#include "texplorer/files/file_io.h"

namespace texplorer {

/// The number of bytes that identify a file's format.
inline constexpr std::size_t recognisedBytes = 4096;

/// Reads the bytes of an image file. Its first bytes are checked before the rest is read: any other file is
/// Unsupported, regardless of its size. Errors name the path: those of readFile.
[[nodiscard]] Result<Bytes> readImageFile(const std::filesystem::path& path,
                                          std::size_t maxBytes = defaultMaxFileBytes,
                                          const ReadObserver& observer = {});

} // namespace texplorer
