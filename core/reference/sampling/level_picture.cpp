#include "texplorer/reference/sampling/level_picture.h"

#include "texplorer/image/convert.h"
#include "texplorer/image/cube_faces.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <algorithm>

namespace texplorer::reference {

namespace {

BaseFormat baseFormatOf(const Surface& surface, const TextureLevels& levels) {
    if (const auto* blocks = std::get_if<BlockImage>(&surface))
        return baseFormat(blocks->format);
    return levels.driverFormat ? baseFormat(*levels.driverFormat) : baseFormat(levels.internalFormat);
}

/// Rows in the order they have.
Image sourcePicture(const Surface& surface, const TextureLevels& levels, Target target) {
    const int border = levels.border;
    return sourceColors(toImage(surface), baseFormatOf(surface, levels), border,
                        target == Target::Texture1D ? 0 : border);
}

} // namespace

Image sourceColors(const Image& image, BaseFormat format, int borderS, int borderT) {
    // Which number each component is: of 0, 1 and those of the pixel, which sourceColor takes for colours.
    const auto numbers = glm::ivec4(sourceColor(format, {2, 3, 4, 5}));
    const int slice = image.depth / 2;
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    Image picture =
        Image::uninitialised(PixelFormat::Rgba8, image.width - 2 * borderS, image.height - 2 * borderT);
    std::byte* to = picture.pixels.data();
    for (int y = 0; y < picture.height; ++y) {
        const std::byte* from = image.pixels.data() + image.offset(borderS, y + borderT, slice);
        for (int x = 0; x < picture.width; ++x) {
            const auto [r, g, b, a] = rgbaOf(image.format, from);
            const std::array<std::uint8_t, 6> values{0, 255, r, g, b, a};
            for (int i = 0; i < 4; ++i)
                *to++ = std::byte{values[static_cast<std::size_t>(numbers[i])]};
            from += step;
        }
    }
    return picture;
}

Result<Image> levelPicture(const TextureLevels& levels, int number, Target target) {
    const auto find = [&](int face) {
        return std::ranges::find_if(levels.levels, [number, face](const TextureLevel& level) {
            return level.number == number && level.face == face;
        });
    };
    const auto first = find(0);
    if (first == levels.levels.end())
        return fail(ErrorCode::NotFound, Sentence("there is no level {0}", number));
    if (target != Target::CubeMap) {
        Image picture = sourcePicture(first->surface, levels, target);
        if (levels.lateFlip != LateFlip::None)
            flipVertically(picture);
        return picture;
    }
    std::array<Image, cubeFaceCount> faces;
    for (int face = 0; face < cubeFaceCount; ++face) {
        const auto found = find(face);
        if (found == levels.levels.end())
            return fail(ErrorCode::NotFound,
                        Sentence("there is no level {0} of {1}", number, rowOf(cubeFaceAt(face)).name));
        faces[static_cast<std::size_t>(face)] = sourcePicture(found->surface, levels, target);
    }
    const Image& plusX = faces.front();
    for (const Image& face : faces) {
        if (face.width != plusX.width || face.height != plusX.height || face.width != face.height)
            return fail(ErrorCode::Unsupported, "the faces of the cube map differ in size");
    }
    Image cross = cubeCross(faces);
    flipVertically(cross);
    return cross;
}

TexelStatistics statisticsOf(const Image& image) {
    TexelStatistics statistics;
    auto& components = statistics.components;
    for (std::size_t at = 0; at + 3 < image.pixels.size(); at += 4) {
        std::array<int, 4> texel{};
        for (std::size_t i = 0; i < 4; ++i) {
            texel[i] = std::to_integer<int>(image.pixels[at + i]);
            ++components[i].counts[static_cast<std::size_t>(texel[i])];
        }
        ++components[TexelStatistics::luminance]
              .counts[static_cast<std::size_t>(luminanceOf(texel[0], texel[1], texel[2]))];
    }
    for (ComponentStatistics& each : components) {
        const auto isThere = [](std::uint32_t count) { return count > 0; };
        const auto least = std::ranges::find_if(each.counts, isThere);
        if (least == each.counts.end())
            continue;
        each.least = static_cast<int>(least - each.counts.begin());
        double sum = 0;
        double texels = 0;
        for (int value = 0; value < 256; ++value) {
            const double count = each.counts[static_cast<std::size_t>(value)];
            if (count > 0)
                each.most = value;
            sum += count * value;
            texels += count;
        }
        each.mean = sum / texels;
    }
    return statistics;
}

} // namespace texplorer::reference
