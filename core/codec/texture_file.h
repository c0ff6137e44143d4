#pragma once

// From a file to a texture and back, whichever format it is.

#include "core/base/result.h"
#include "core/codec/common/decode_limits.h"
#include "core/codec/common/write_options.h"
#include "core/image/texture_image.h"

#include <filesystem>

namespace texplorer {

/// Reads a file of any format that codecRows() names, recognised by its content: all faces, levels and
/// slices, compressed blocks as they are. Of a picture the rows are bottom first, of a DDS file as it has
/// them (TextureImage::topFirst). Errors name the path: those of the reading (NotFound, Unreadable), TooLarge
/// above `limits` or without memory, Unsupported for a format or a variant that is not read, Malformed for a
/// damaged file.
[[nodiscard]] Result<TextureImage> loadTexture(const std::filesystem::path& path,
                                               const DecodeLimits& limits = {});

/// Writes a file of the format that its extension names (.bmp, .dds, .png, .tga), as a whole or not at all:
/// what was there before stays after an error. DDS takes everything, the others face 0, level 0,
/// decompressed, upright. Errors name the path: Unsupported for another extension or what the format can't
/// hold, Unwritable, TooLarge without memory.
[[nodiscard]] Result<void> saveTexture(const TextureImage& texture, const std::filesystem::path& path,
                                       const WriteOptions& options = {});

} // namespace texplorer
