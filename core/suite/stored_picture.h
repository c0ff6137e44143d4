#pragma once

// Goldens, masks and pictures of other programs, in files.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/image/image.h"

#include <filesystem>

namespace texplorer::suite {

struct StoredPicture {
    Bytes bytes; ///< of the file
    Image image;
};

/// Reads a picture. Errors, with the file in `where`: those of readFile, and of the decoder; Git LFS pointers
/// are recognised.
[[nodiscard]] Result<StoredPicture> readStoredPicture(const std::filesystem::path& file);

/// Whether the error is in the file's content, not in reading it.
[[nodiscard]] bool isNoPicture(const Error& error);

} // namespace texplorer::suite
