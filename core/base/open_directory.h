#pragma once

#include "core/base/descriptor.h"

#include <filesystem>

namespace texplorer {

/// A directory to make and name files in, held open: it stays the same, whatever becomes of its name. An
/// empty path is the current one. Empty after a failure, whose errno stays.
[[nodiscard]] Descriptor openDirectory(const std::filesystem::path& path);

} // namespace texplorer
