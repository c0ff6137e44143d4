#pragma once

#include "core/image/texture_image.h"

#include <string_view>
#include <vector>

namespace texplorer {

/// What a texture's file had and a file of another format, or of the same, won't have: what decoding has lost
/// already, and what the format can't hold. Formats of one picture take face 0, level 0 and slice 0.
[[nodiscard]] std::vector<Loss> lossesIn(const TextureImage& texture, std::string_view format);

/// "16 bits a component become 8; 2 of the array's 3 layers": the sentences of the losses of pixels.
[[nodiscard]] std::string pixelsLost(const std::vector<Loss>& losses);

} // namespace texplorer
