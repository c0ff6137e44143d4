#pragma once

#include "core/base/result.h"
#include "core/scene/params/json.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace texplorer {

/// Unsaved work: a scene, and where it belongs.
struct UnsavedScene {
    std::filesystem::path file;   ///< the scene file that it was opened from or saved to; empty: none
    std::filesystem::path folder; ///< what relative image paths are resolved against; empty: there is none
    Scene scene;
    std::string fileHash{}; ///< of what `file` had in it when it was read or written last; empty: not known

    bool operator==(const UnsavedScene&) const = default;
};

/// The longest text that parseUnsaved looks at.
inline constexpr std::size_t maxUnsavedBytes = maxSceneBytes + (std::size_t{64} << 10);

/// A line that says what it is, a line with the file, one with the folder, one with the hash, and the scene
/// as writeScene has it. In paths control characters and % are written as %0A, so that every name of a file
/// system fits in.
[[nodiscard]] std::string writeUnsaved(const UnsavedScene& draft);

/// parseUnsaved(writeUnsaved(d)) == d wherever parseScene(writeScene(d.scene)) == d.scene. Drafts of version
/// 1 have no hash. Errors: it is no draft, a path is neither empty nor absolute, and those of parseScene.
[[nodiscard]] Result<UnsavedScene> parseUnsaved(std::string_view text);

} // namespace texplorer
