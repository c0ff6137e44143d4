#include "texplorer/image/mip_colors.h"

#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"

namespace texplorer {

// 128 texels a side make a chain of exactly eight levels, so that no colour appears twice.
Image drawMipColors() {
    constexpr int size = 128;
    Canvas canvas(size, size);
    canvas.fill(0, 0, size, size, mipColor(0));
    return std::move(canvas).take();
}

} // namespace texplorer
