#include "texplorer/s3tc/surface_pixels.h"

#include "texplorer/s3tc/decode.h"

#include <utility>

namespace texplorer {

Image toImage(Surface surface) {
    if (Image* image = std::get_if<Image>(&surface))
        return std::move(*image);
    return decodeBlocks(std::get<BlockImage>(surface));
}

Image uprightImage(TextureImage texture) {
    Image image = toImage(std::move(texture.surfaces.front()));
    if (texture.topFirst)
        flipVertically(image);
    return image;
}

} // namespace texplorer
