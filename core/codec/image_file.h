#pragma once

#include "core/base/result.h"
#include "core/image/image.h"

#include <filesystem>
#include <string_view>

namespace texplorer {

struct ImageFile {
    std::string_view format;   ///< "BMP"
    std::size_t fileBytes = 0; ///< as it lies on the disk
    Image image;
};

/// Reads a file and decodes whichever format it is. Errors are those of readFile and decodeImage; their
/// `where` is the path.
[[nodiscard]] Result<ImageFile> readImageFile(const std::filesystem::path& path);

} // namespace texplorer
