#pragma once

// Mesa keeps compiled shaders in the user's cache directory and maps the index of that cache into memory. If
// the disk is full, or the file system goes away while it is mapped, access to the index is a bus error.

#include "texplorer/base/result.h"

#include <filesystem>

namespace texplorer::render {

/// Call it before the first OpenGL context is created and before other threads start. Gives the driver a
/// cache that passed `checkDriverCache`, in Texplorer's cache directory or where the user's MESA_* variables
/// say; or disables the cache. Sets environment variables (MESA_SHADER_CACHE_DIR, MESA_SHADER_CACHE_DISABLE).
void setUpDriverCache();

/// Creates the directory (mode 0700) if it is missing and allocates the disk blocks of Mesa's index. Fails
/// for a link, another user's directory, a directory that others can write to, and if there is no space for
/// the index.
[[nodiscard]] Result<void> checkDriverCache(const std::filesystem::path& directory);

} // namespace texplorer::render
