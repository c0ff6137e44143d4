#include "texplorer/image/mirror.h"

#include <algorithm>

namespace texplorer {

void mirror(Image& image) {
    const auto pixel = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t row = 0; row < image.pixels.size(); row += image.rowBytes()) {
        std::byte* left = image.pixels.data() + row;
        std::byte* right = left + image.rowBytes() - pixel;
        for (; left < right; left += pixel, right -= pixel)
            std::swap_ranges(left, left + pixel, right);
    }
}

} // namespace texplorer
