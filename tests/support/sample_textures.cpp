#include "tests/support/sample_textures.h"

#include "texplorer/image/mipmaps.h"

#include <algorithm>
#include <random>

namespace texplorer::test {
namespace {

/// Runs as well as noise, for run-length coders.
void fill(Bytes& bytes) {
    std::mt19937 random(static_cast<unsigned>(bytes.size())); // NOLINT: the same bytes each time
    std::byte value{};
    for (std::byte& byte : bytes) {
        if (random() % 3 == 0)
            value = static_cast<std::byte>(random() >> 24);
        byte = value;
    }
}

Image picture(PixelFormat format, int width, int height, int depth = 1) {
    Image image = Image::uninitialised(format, width, height, depth);
    fill(image.pixels);
    return image;
}

BlockImage blocks(BlockFormat format, int width, int height, int depth = 1) {
    BlockImage image = BlockImage::uninitialised(format, width, height, depth);
    fill(image.blocks);
    return image;
}

/// Every face gets the chain that `surfaceOf` gives for the extents of each level.
template<class SurfaceOf>
TextureImage chain(int faces, int width, int height, int depth, SurfaceOf surfaceOf) {
    TextureImage texture;
    texture.faces = faces;
    texture.levels = mipLevelCount(width, height, depth);
    texture.topFirst = true;
    texture.alpha = AlphaMeaning::Straight;
    for (int face = 0; face < faces; ++face)
        for (int level = 0; level < texture.levels; ++level)
            texture.surfaces.emplace_back(surfaceOf(std::max(1, width >> level), std::max(1, height >> level),
                                                    std::max(1, depth >> level)));
    return texture;
}

} // namespace

std::vector<TextureImage> sampleTextures() {
    std::vector<TextureImage> textures;
    for (const PixelFormatRow& row : colorFormatRows)
        for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {17, 5}})
            textures.push_back(textureOf(picture(row.format, width, height), {}));
    textures.push_back(textureOf(picture(PixelFormat::Rgba8, 4, 2, 3), {}));
    const auto pixels = [](int width, int height, int depth) {
        return picture(PixelFormat::Rgba8, width, height, depth);
    };
    textures.push_back(chain(1, 5, 3, 1, pixels));
    textures.push_back(chain(6, 4, 4, 1, pixels));
    textures.push_back(chain(1, 4, 2, 4, pixels));
    for (const EnumRow& row : blockFormatRows) {
        const auto format = static_cast<BlockFormat>(row.value);
        const auto compressed = [&](int width, int height, int depth) {
            return blocks(format, width, height, depth);
        };
        TextureImage one = chain(1, 8, 4, 1, compressed);
        one.surfaces.resize(1);
        one.levels = 1;
        textures.push_back(std::move(one));
        textures.push_back(chain(1, 7, 12, 1, compressed));
        textures.push_back(chain(6, 4, 4, 1, compressed));
        textures.push_back(chain(1, 4, 4, 2, compressed));
    }
    return textures;
}

std::vector<Bytes> sampleFiles(const CodecRow& row) {
    std::vector<Bytes> files;
    if (!row.encode)
        return files;
    for (const TextureImage& texture : sampleTextures())
        for (const WriteOptions& options :
             {WriteOptions{}, WriteOptions{.small = true, .runLengthCoded = true}})
            if (Result<Bytes> file = row.encode(texture, options))
                if (std::ranges::find(files, *file) == files.end())
                    files.push_back(std::move(*file));
    return files;
}

} // namespace texplorer::test
