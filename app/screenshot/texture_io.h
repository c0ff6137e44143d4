#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/registry.h"
#include "core/image/texture_image.h"

#include <string>

namespace texplorer::screenshot {

/// Reads and decodes a file. Errors name the path.
[[nodiscard]] Result<TextureImage> readTexture(const std::string& path);

/// The row whose format the file name's extension asks for and that can be written; the error lists those
/// that can.
[[nodiscard]] Result<const CodecRow*> writerFor(const std::string& path);

/// Encodes by the file name's extension and writes atomically.
[[nodiscard]] Result<void> writeTexture(const std::string& path, const TextureImage& texture,
                                        const WriteOptions& options = {});

} // namespace texplorer::screenshot
