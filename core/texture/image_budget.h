#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/image/texture_image.h"

#include <string>

namespace texplorer {

/// The limit for all decoded images of a scene together, equal to the limit of a single one. A file that
/// several textures use counts once.
inline constexpr std::size_t sceneImageBytes = DecodeLimits{}.maxBytes;

/// "2 GiB"
[[nodiscard]] std::string sceneImageBytesText();

/// The error for an image that needs more bytes than are left of sceneImageBytes.
[[nodiscard]] Error beyondBudget(std::size_t needed, std::size_t left);

enum class Decoding : bool { Outline, Pixels };

/// decodeTexture, if the image needs at most `left` bytes of sceneImageBytes, which is checked before memory
/// for its pixels is allocated. `stop`: as in DecodeLimits. Errors: those of decodeTexture, and beyondBudget.
[[nodiscard]] Result<TextureImage> decodeWithin(ByteView file, std::size_t left,
                                                Decoding decoding = Decoding::Pixels,
                                                const std::stop_token* stop = nullptr);

} // namespace texplorer
