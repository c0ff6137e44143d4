#pragma once

// Loads and saves textures in any known format.

#include "texplorer/base/result.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/texture_image.h"

#include <filesystem>

namespace texplorer {

/// Reads a file of any format in codecRows(), recognised by its content: all faces, levels and slices;
/// compressed blocks stay compressed. Pictures have the bottom row first; DDS files keep their order
/// (TextureImage::topFirst). Errors name the path: those of reading (NotFound, Unreadable), TooLarge above
/// `limits` or without memory, Unsupported for an unsupported format or variant, Malformed for a damaged
/// file.
[[nodiscard]] Result<TextureImage> loadTexture(const std::filesystem::path& path,
                                               const DecodeLimits& limits = {});

/// Writes a file of the format of its extension (.bmp, .dds, .png, .tga), completely or not at all: after an
/// error, an existing file is unchanged. DDS stores everything; other formats store face 0, level 0,
/// decompressed and upright. Errors name the path: Unsupported for another extension or what the format
/// cannot store, Unwritable, TooLarge without memory.
[[nodiscard]] Result<void> saveTexture(const TextureImage& texture, const std::filesystem::path& path,
                                       const WriteOptions& options = {});

} // namespace texplorer
