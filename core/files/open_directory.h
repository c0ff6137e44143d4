#pragma once

#include "texplorer/files/descriptor.h"

#include <filesystem>

namespace texplorer {

/// Opens a directory to create and rename files in. It stays the same directory even if its name changes. An
/// empty path is the current directory. Returns an empty descriptor and leaves errno on failure.
[[nodiscard]] Descriptor openDirectory(const std::filesystem::path& path);

} // namespace texplorer
