#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/image/texture_image.h"

#include <string_view>
#include <vector>

namespace texplorer {

/// Returns what is in a texture's source file and would be missing in a file of the given format: what
/// decoding has lost, and what the format cannot store. Formats of one picture store face 0, level 0 and
/// slice 0.
[[nodiscard]] std::vector<Loss> lossesIn(const TextureImage& texture, std::string_view format);

/// Returns what a block format would not store: the components that matter in one of the pictures. In greys,
/// red stands for green and blue, too.
[[nodiscard]] std::vector<Loss> lossesIn(const MipChain& pictures, BlockFormat format);

/// "16 bits a component become 8; 2 of the array's 3 layers": all sentences in one, and those about pixels.
[[nodiscard]] Sentence allLost(const std::vector<Loss>& losses);
[[nodiscard]] Sentence pixelsLost(const std::vector<Loss>& losses);

} // namespace texplorer
