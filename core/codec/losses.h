#pragma once

#include "core/image/texture_image.h"

#include <string_view>
#include <vector>

namespace texplorer {

/// What a texture's file had and a file of another format, or of the same, won't have: what decoding has lost
/// already, and what the format can't hold. Formats of one picture take face 0, level 0 and slice 0.
[[nodiscard]] std::vector<Loss> lossesIn(const TextureImage& texture, std::string_view format);

/// What blocks of a format keep nothing of: the components that say something in one of the pictures. Of
/// greys red says what green and blue say, too.
[[nodiscard]] std::vector<Loss> lossesIn(const MipChain& pictures, BlockFormat format);

/// "16 bits a component become 8; 2 of the array's 3 layers": the sentences of all, and of the losses of
/// pixels.
[[nodiscard]] std::string allLost(const std::vector<Loss>& losses);
[[nodiscard]] std::string pixelsLost(const std::vector<Loss>& losses);

} // namespace texplorer
