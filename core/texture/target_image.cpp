#include "texplorer/texture/target_image.h"

#include <algorithm>

namespace texplorer {

Image imageForTarget(const Image& image, Target target) {
    if (image.empty())
        return {};
    const int slices = target == Target::Texture3D ? image.depth : 1;
    const int rows = target == Target::Texture1D ? 1 : image.height;
    const int firstSlice = target == Target::Texture3D ? 0 : image.depth / 2;
    const int firstRow = target == Target::Texture1D ? image.height / 2 : 0;

    // Rows and slices follow each other without gaps, so each of the three parts is one run of bytes.
    Image part = Image::uninitialised(image.format, image.width, rows, slices);
    std::copy_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(image.offset(0, firstRow, firstSlice)),
                part.pixels.size(), part.pixels.begin());
    return part;
}

} // namespace texplorer
