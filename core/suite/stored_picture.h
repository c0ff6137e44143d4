#pragma once

// Goldens, masks and pictures of other programs, as files.

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/image/image.h"

#include <filesystem>

namespace texplorer::suite {

struct StoredPicture {
    Bytes bytes; ///< of the file
    Image image;
};

/// Errors, with the file in `where`: those of readFile; what the decoder says, which names a pointer of Git
/// LFS.
[[nodiscard]] Result<StoredPicture> readStoredPicture(const std::filesystem::path& file);

/// Whether that error is about what the file holds; else it is about reading it.
[[nodiscard]] bool isNoPicture(const Error& error);

} // namespace texplorer::suite
