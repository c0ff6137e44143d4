#pragma once

#include "core/base/file_io.h"

namespace texplorer {

/// So many bytes tell what a file is.
inline constexpr std::size_t recognisedBytes = 4096;

/// The bytes of an image file, of which the first are looked at before the others are read: of what is no
/// image Unsupported, however large it is. Errors name the path: those of readFile.
[[nodiscard]] Result<Bytes> readImageFile(const std::filesystem::path& path,
                                          std::size_t maxBytes = defaultMaxFileBytes,
                                          const ReadObserver& observer = {});

} // namespace texplorer
