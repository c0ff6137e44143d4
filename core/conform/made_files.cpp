#include "texplorer/conform/made_files.h"

#include "texplorer/codec/dds/dds.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/patterns/pattern.h"

#include <cassert>

namespace texplorer::conform {

Bytes bytesOf(const MadeFile& file) {
    constexpr int fileExtent = 64;
    TextureImage texture;
    texture.alpha = AlphaMeaning::Straight;
    texture.levels = file.levels;
    for (Image& level : buildMipChain(drawPattern(Pattern::Tree))) {
        if (level.width <= fileExtent && static_cast<int>(texture.surfaces.size()) < file.levels)
            texture.surfaces.emplace_back(std::move(level));
    }
    Result<Bytes> bytes = encodeDds(texture);
    assert(bytes && "a chain of RGBA levels can be written");
    return *std::move(bytes);
}

const ImageSource& madeImages() {
    static const ImageSource images = [] {
        ImageSource made;
        for (const MadeFile& file : madeFiles)
            made.put(std::string(file.name), *decodeDds(bytesOf(file)));
        return made;
    }();
    return images;
}

} // namespace texplorer::conform
