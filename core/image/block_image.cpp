#include "texplorer/image/block_image.h"

#include <string>

namespace texplorer {

Result<void> checkBlocks(const BlockImage& image) {
    const bool positive = image.width > 0 && image.height > 0 && image.depth > 0;
    const std::size_t needed =
        positive ? image.blockRowBytes() * image.blockRows() * static_cast<std::size_t>(image.depth) : 0;
    if (positive && image.blocks.size() == needed)
        return {};
    return fail(
        ErrorCode::Malformed,
        Sentence("a compressed picture of {0} × {1} × {2} texels needs {3} bytes of blocks, there are {4}",
                 image.width, image.height, image.depth, needed, image.blocks.size()));
}

} // namespace texplorer
