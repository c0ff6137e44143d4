#include "core/image/block_image.h"

#include <string>

namespace texplorer {

Result<void> checkBlocks(const BlockImage& image) {
    const bool positive = image.width > 0 && image.height > 0 && image.depth > 0;
    const std::size_t needed =
        positive ? image.blockRowBytes() * image.blockRows() * static_cast<std::size_t>(image.depth) : 0;
    if (positive && image.blocks.size() == needed)
        return {};
    return fail(ErrorCode::Malformed, "a compressed picture of " + std::to_string(image.width) + " x " +
                                          std::to_string(image.height) + " x " + std::to_string(image.depth) +
                                          " texels needs " + std::to_string(needed) +
                                          " bytes of blocks, there are " +
                                          std::to_string(image.blocks.size()));
}

} // namespace texplorer
