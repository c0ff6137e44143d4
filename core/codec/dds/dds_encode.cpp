#include "texplorer/base/sentence.h"
#include "texplorer/codec/common/swizzle.h"
#include "texplorer/codec/dds/dds.h"
#include "texplorer/codec/dds/dds_pixels.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/flip.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace texplorer {
namespace {

using namespace dds;

constexpr MaskedPixels bgr{24, {0xFF0000, 0xFF00, 0xFF, 0}, PixelFormat::Rgb8};
constexpr MaskedPixels bgrx{32, {0xFF0000, 0xFF00, 0xFF, 0}, PixelFormat::Rgb8};
constexpr MaskedPixels bgra{32, {0xFF0000, 0xFF00, 0xFF, 0xFF000000}, PixelFormat::Rgba8};
constexpr MaskedPixels rgba{32, {0xFF, 0xFF00, 0xFF0000, 0xFF000000}, PixelFormat::Rgba8};
constexpr MaskedPixels luminance{8, {0xFF, 0, 0, 0}, PixelFormat::Luminance8};
constexpr MaskedPixels luminanceAlpha{16, {0xFF, 0, 0, 0xFF00}, PixelFormat::LuminanceAlpha8};
constexpr MaskedPixels alphaAlone{8, {0, 0, 0, 0xFF}, PixelFormat::Alpha8};

tl::unexpected<Error> refuse(const Sentence& message) {
    return fail(ErrorCode::OutOfRange, Sentence("DDS: {0}", message));
}

std::string extentsOf(const Surface& surface) {
    return fmt::format("{} × {} × {}", widthOf(surface), heightOf(surface), depthOf(surface));
}

bool sameFormat(const Surface& a, const Surface& b) {
    if (a.index() != b.index())
        return false;
    if (const Image* image = std::get_if<Image>(&a))
        return image->format == std::get<Image>(b).format;
    return std::get<BlockImage>(a).format == std::get<BlockImage>(b).format;
}

/// The format says nothing about any surface but the first, so that all the others must follow from it.
Result<void> check(const TextureImage& texture) {
    if (texture.faces != 1 && texture.faces != 6)
        return refuse(Sentence("a texture has 1 or 6 faces, this one has {0}", texture.faces));
    if (texture.layers < 1 || texture.levels < 1 ||
        texture.surfaces.size() != static_cast<std::size_t>(texture.layers) *
                                       static_cast<std::size_t>(texture.faces) *
                                       static_cast<std::size_t>(texture.levels))
        return refuse(Sentence("{0} of {1} faces with {2} levels are expected, there are {3} surfaces",
                               Sentence::plural("{0} layer", "{0} layers", texture.layers), texture.faces,
                               texture.levels, texture.surfaces.size()));
    const Surface& base = texture.surfaces.front();
    const int width = widthOf(base);
    const int height = heightOf(base);
    const int depth = depthOf(base);
    if (width < 1 || height < 1 || depth < 1)
        return refuse(Sentence("a texture has at least 1 × 1 × 1 texels, this one has {0}", extentsOf(base)));
    if (texture.faces == 6 && (width != height || depth != 1))
        return refuse(Sentence("the faces of a cube map are square, these are {0}", extentsOf(base)));
    if (texture.layers > 1 && depth != 1)
        return refuse(Sentence("the layers of an array are no volumes, these are {0}", extentsOf(base)));
    if (texture.levels > mipLevelCount(width, height, depth))
        return refuse(Sentence("a mip chain of {0} texels has at most {1} levels, this one has {2}",
                               extentsOf(base), mipLevelCount(width, height, depth), texture.levels));
    for (int face = 0; face < texture.layers * texture.faces; ++face)
        for (int level = 0; level < texture.levels; ++level) {
            const Surface& surface = texture.surface(face, level);
            const auto expected = [&](int extent) { return std::max(1, extent >> level); };
            if (widthOf(surface) != expected(width) || heightOf(surface) != expected(height) ||
                depthOf(surface) != expected(depth))
                return refuse(Sentence("level {0} of {1} texels is no mip level of {2}", level,
                                       extentsOf(surface), extentsOf(base)));
            if (!sameFormat(surface, base))
                return refuse(Sentence("level {0} has another format than level 0", level));
            if (bytesHeld(surface) != byteCount(surface))
                return refuse(Sentence("level {0} needs {1} bytes, it has {2}", level, byteCount(surface),
                                       bytesHeld(surface)));
        }
    return {};
}

const DxgiRow* findDxgi(const Pixels& pixels, bool srgb) {
    const auto found = std::ranges::find_if(dxgiRows(), [&](const DxgiRow& row) {
        return row.pixels == pixels && row.srgb == srgb && !row.name.ends_with("_TYPELESS");
    });
    return found == dxgiRows().end() ? nullptr : &*found;
}

std::uint32_t alphaModeFor(AlphaMeaning alpha) {
    switch (alpha) {
    case AlphaMeaning::None:
        return alphaOpaque;
    case AlphaMeaning::Straight:
        return alphaStraight;
    case AlphaMeaning::Premultiplied:
        return alphaPremultiplied;
    case AlphaMeaning::Unknown:
        break;
    }
    return alphaUnknown;
}

void putExtended(Header& header, const DxgiRow& row, std::uint32_t alphaMode, const TextureImage& texture) {
    header.formatFlags = formatFourCC;
    header.fourCC = fourCC("DX10");
    header.dxgiFormat = row.number;
    header.dimension = depthOf(texture.surfaces.front()) > 1 ? dimension3D : dimension2D;
    header.miscFlag = texture.faces == 6 ? miscTextureCube : 0;
    header.arraySize = static_cast<std::uint32_t>(texture.layers);
    header.miscFlags2 = alphaMode;
}

void putBlockFormat(Header& header, BlockFormat format, const TextureImage& texture) {
    const BlockFormat stored = format == BlockFormat::Dxt1Alpha ? BlockFormat::Dxt1 : format;
    const bool premultiplied = texture.alpha == AlphaMeaning::Premultiplied;
    const auto isOpaqueDespiteItsCodes = [](const Surface& surface) {
        const BlockImage& image = std::get<BlockImage>(surface);
        return hasPunchThrough(image.blocks, image.width, image.height, image.depth);
    };
    const DxgiRow* srgb = texture.srgb ? findDxgi(Pixels{stored}, true) : nullptr;
    const bool opaque = format == BlockFormat::Dxt1;
    const bool onlyExtended = (format == BlockFormat::Dxt1Alpha && premultiplied) ||
                              (opaque && std::ranges::any_of(texture.surfaces, isOpaqueDespiteItsCodes));
    if (srgb != nullptr || onlyExtended || texture.layers > 1) {
        std::uint32_t mode = opaque ? alphaOpaque : alphaModeFor(texture.alpha);
        if (format == BlockFormat::Dxt1Alpha && !premultiplied)
            mode = alphaStraight;
        if (stored != BlockFormat::Dxt1 && stored != BlockFormat::Dxt3 && stored != BlockFormat::Dxt5)
            mode = alphaUnknown;
        return putExtended(header, srgb != nullptr ? *srgb : *findDxgi(Pixels{stored}, false), mode, texture);
    }
    const bool hasTwin = stored == BlockFormat::Dxt3 || stored == BlockFormat::Dxt5;
    const auto row = std::ranges::find_if(fourCCRows(), [&](const FourCCRow& each) {
        return each.format == stored &&
               (!hasTwin || (each.alpha == AlphaMeaning::Premultiplied) == premultiplied);
    });
    header.formatFlags = formatFourCC | (format == BlockFormat::Dxt1Alpha ? formatAlphaPixels : 0U);
    header.fourCC = row->code;
}

MaskedPixels legacyPixels(PixelFormat format) {
    switch (format) {
    case PixelFormat::Alpha8:
        return alphaAlone;
    case PixelFormat::Luminance8:
        return luminance;
    case PixelFormat::LuminanceAlpha8:
        return luminanceAlpha;
    case PixelFormat::Rgb8:
        return bgr;
    case PixelFormat::Rgba8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        break;
    }
    return bgra;
}

/// Chooses how pixels are stored and says so in the header.
MaskedPixels putPixelFormat(Header& header, PixelFormat format, const TextureImage& texture) {
    const bool alpha = format == PixelFormat::Rgba8 || format == PixelFormat::LuminanceAlpha8;
    const bool premultiplied = alpha && texture.alpha == AlphaMeaning::Premultiplied;
    const bool colors = format != PixelFormat::Alpha8 && (texture.srgb || premultiplied);
    if (colors || texture.layers > 1) {
        const bool single = !colors && bytesPerPixel(format) == 1; // R8 is read as grey
        const MaskedPixels pixels = single ? legacyPixels(format) : alpha ? rgba : bgrx;
        putExtended(header, *findDxgi(Pixels{pixels}, colors && texture.srgb),
                    alpha ? alphaModeFor(texture.alpha) : alphaUnknown, texture);
        return pixels;
    }
    const MaskedPixels pixels = legacyPixels(format);
    header.bitCount = static_cast<std::uint32_t>(pixels.bits);
    header.masks = pixels.masks;
    const bool grey = format == PixelFormat::Luminance8 || format == PixelFormat::LuminanceAlpha8;
    header.formatFlags = (format == PixelFormat::Alpha8 ? formatAlpha
                          : grey                        ? formatLuminance
                                                        : formatRgb) |
                         (alpha ? formatAlphaPixels : 0U);
    return pixels;
}

Header describe(const TextureImage& texture) {
    const Surface& base = texture.surfaces.front();
    Header header;
    header.flags = flagCaps | flagHeight | flagWidth | flagPixelFormat;
    header.width = static_cast<std::uint32_t>(widthOf(base));
    header.height = static_cast<std::uint32_t>(heightOf(base));
    header.mipMapCount = static_cast<std::uint32_t>(texture.levels);
    header.caps = capsTexture;
    if (texture.levels > 1) {
        header.flags |= flagMipMapCount;
        header.caps |= capsMipMap | capsComplex;
    }
    if (texture.faces == 6) {
        header.caps |= capsComplex;
        header.caps2 = caps2CubeMap | caps2AllFaces;
    }
    if (depthOf(base) > 1) {
        header.flags |= flagDepth;
        header.depth = static_cast<std::uint32_t>(depthOf(base));
        header.caps |= capsComplex;
        header.caps2 = caps2Volume;
    }
    return header;
}

/// One component becomes three, so that formats with colours can hold greys.
Bytes asColors(const Image& image) {
    const bool alpha = image.format == PixelFormat::LuminanceAlpha8;
    Bytes colors(image.pixels.size() / (alpha ? 2 : 1) * (alpha ? 4 : 3));
    std::byte* to = colors.data();
    for (auto from = image.pixels.begin(); from != image.pixels.end();) {
        to = std::fill_n(to, 3, *from++);
        if (alpha)
            *to++ = *from++;
    }
    return colors;
}

void packPixels(const Image& image, const MaskedPixels& pixels, std::byte* to) {
    const bool grey = image.format == PixelFormat::Luminance8 || image.format == PixelFormat::LuminanceAlpha8;
    const bool colors = pixels.decoded == PixelFormat::Rgb8 || pixels.decoded == PixelFormat::Rgba8;
    const Bytes greys = grey && colors ? asColors(image) : Bytes();
    const Bytes& from = grey && colors ? greys : image.pixels;
    if (pixels == bgr)
        return swapRedBlue(from.data(), to, from.size() / 3);
    if (pixels == bgra)
        return swapRedBlueAlpha(from.data(), to, from.size() / 4);
    if (pixels != bgrx) {
        std::memcpy(to, from.data(), from.size());
        return;
    }
    for (std::size_t i = 0; i < from.size(); i += 3, to += 4) {
        to[0] = from[i + 2];
        to[1] = from[i + 1];
        to[2] = from[i];
        to[3] = std::byte{255};
    }
}

/// DDS has the top row first.
Result<void> turn(Surface& surface, int level) {
    if (Image* image = std::get_if<Image>(&surface)) {
        flipVertically(*image);
        return {};
    }
    if (flipVertically(std::get<BlockImage>(surface)))
        return {};
    return fail(
        ErrorCode::Unsupported,
        Sentence(
            "DDS: the top row comes first in a file; level {0} has {1} rows, bottom row first, and blocks are "
            "turned without loss where there are {2}",
            level, heightOf(surface), losslessExtents));
}

} // namespace

Result<Bytes> encodeDds(const TextureImage& texture, const WriteOptions&) {
    if (const Result<void> checked = check(texture); !checked)
        return fail(checked.error());
    try {
        const Surface& base = texture.surfaces.front();
        Header header = describe(texture);
        MaskedPixels pixels;
        if (const Image* image = std::get_if<Image>(&base)) {
            pixels = putPixelFormat(header, image->format, texture);
            header.flags |= flagPitch;
            header.pitchOrLinearSize =
                static_cast<std::uint32_t>(pixels.bytes() * static_cast<std::size_t>(image->width));
        } else {
            putBlockFormat(header, std::get<BlockImage>(base).format, texture);
            header.flags |= flagLinearSize;
            header.pitchOrLinearSize =
                static_cast<std::uint32_t>(byteCount(base) / static_cast<std::size_t>(depthOf(base)));
        }

        const auto storedBytes = [&](const Surface& surface) {
            const Image* image = std::get_if<Image>(&surface);
            return image == nullptr
                       ? byteCount(surface)
                       : byteCount(surface) / static_cast<std::size_t>(bytesPerPixel(image->format)) *
                             pixels.bytes();
        };
        Bytes file = writeHeader(header);
        std::size_t offset = file.size();
        std::size_t end = offset;
        for (const Surface& surface : texture.surfaces)
            end += storedBytes(surface);
        file.resize(end);
        for (std::size_t i = 0; i < texture.surfaces.size(); ++i) {
            const Surface* surface = &texture.surfaces[i];
            Surface turned;
            if (!texture.topFirst) {
                turned = *surface;
                if (Result<void> done = turn(turned, static_cast<int>(i) % texture.levels); !done)
                    return fail(std::move(done.error()));
                surface = &turned;
            }
            if (const Image* image = std::get_if<Image>(surface))
                packPixels(*image, pixels, file.data() + offset);
            else
                std::memcpy(file.data() + offset, std::get<BlockImage>(*surface).blocks.data(),
                            byteCount(*surface));
            offset += storedBytes(*surface);
        }
        return file;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "DDS: not enough memory for the file");
    }
}

} // namespace texplorer
