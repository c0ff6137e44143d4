#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/params/json.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace texplorer {

/// Unsaved work: a scene and its file.
struct UnsavedScene {
    std::filesystem::path file;   ///< the scene file that it was opened from or saved to; empty: none
    std::filesystem::path folder; ///< relative image paths are resolved against it; empty: none
    Scene scene;
    std::string
        fileHash{}; ///< hash of the content of `file` when it was last read or written; empty: unknown

    bool operator==(const UnsavedScene&) const = default;
};

/// The longest text that parseUnsaved accepts.
inline constexpr std::size_t maxUnsavedBytes = maxSceneBytes + (std::size_t{64} << 10);

/// Writes a line with the format, one with the file, one with the folder, one with the hash, and the scene as
/// writeScene does. In paths, control characters and % are escaped as %0A, so any file name fits in a line.
[[nodiscard]] std::string writeUnsaved(const UnsavedScene& draft);

/// parseUnsaved(writeUnsaved(d)) == d wherever parseScene(writeScene(d.scene)) == d.scene. Drafts of version
/// 1 have no hash. Errors: the text is not a draft, a path is neither empty nor absolute, and the errors of
/// parseScene.
[[nodiscard]] Result<UnsavedScene> parseUnsaved(std::string_view text);

} // namespace texplorer
