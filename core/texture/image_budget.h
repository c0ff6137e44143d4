#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/decode_limits.h"
#include "core/image/texture_image.h"

#include <string>

namespace texplorer {

/// What all images of a scene may take together once they are decoded: as much as the largest of them may. A
/// file that several textures name counts once.
inline constexpr std::size_t sceneImageBytes = DecodeLimits{}.maxBytes;

/// "2 GiB"
[[nodiscard]] std::string sceneImageBytesText();

/// That an image needs more bytes than are left of sceneImageBytes.
[[nodiscard]] Error beyondBudget(std::size_t needed, std::size_t left);

enum class Decoding : bool { Outline, Pixels };

/// decodeTexture of a file's content where its image takes no more than `left` bytes of sceneImageBytes,
/// which is known before any memory is taken for its pixels. Errors are those of decodeTexture, and
/// beyondBudget.
[[nodiscard]] Result<TextureImage> decodeWithin(ByteView file, std::size_t left,
                                                Decoding decoding = Decoding::Pixels);

} // namespace texplorer
