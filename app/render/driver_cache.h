#pragma once

// Mesa keeps compiled shaders below the user's cache directory and maps the index of that cache into memory.
// Where the disk is full, or a file system ends while it is mapped, to touch the index is a bus error.

#include "core/base/result.h"

#include <filesystem>

namespace texplorer::render {

/// To be called before the first OpenGL context is made, while no other thread runs: gives the driver a cache
/// that `checkDriverCache` found fit, below Texplorer's own cache directory or where the user's MESA_* names
/// one; or switches it off. Says so in the environment (MESA_SHADER_CACHE_DIR, MESA_SHADER_CACHE_DISABLE).
void setUpDriverCache();

/// Makes the directory (mode 0700) where it is missing, and gives Mesa's index the blocks on the disk that it
/// needs. Refused: a link, another user's directory or one that others may write to, no space for the index.
[[nodiscard]] Result<void> checkDriverCache(const std::filesystem::path& directory);

} // namespace texplorer::render
