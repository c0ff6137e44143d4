#pragma once

// A scene in a file: JSON, or a PNG that texshot has drawn, which has its scene as a text.

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace texplorer {

/// The keyword of the complete scene in a PNG.
inline constexpr const char* sceneKeyword = "Texplorer scene";

/// How much is read of a file that begins so: of a PNG, which has its pixels beside the scene, all.
[[nodiscard]] std::size_t mostSceneFileBytes(ByteView start);

/// The JSON of a file's bytes: they themselves, or the text of a PNG, bounded as a scene's file is. NotFound:
/// a PNG without one; Malformed, TooLarge. `where` is empty.
[[nodiscard]] Result<std::string> sceneTextIn(ByteView file);

/// The same of a file on the disk, named in `where`.
[[nodiscard]] Result<std::string> readSceneText(const std::filesystem::path& file);

/// Whether a file is a PNG with such a text, whatever that says, among its first chunks. Reads little more
/// than where these begin; false, too, where it can't be read.
[[nodiscard]] bool isPictureWithScene(const std::filesystem::path& file, std::size_t mostChunks = 100'000);

} // namespace texplorer
