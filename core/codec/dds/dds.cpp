#include "texplorer/codec/dds/dds.h"

#include "texplorer/codec/dds/dds_layout.h"
#include "texplorer/codec/dds/dds_pixels.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace texplorer {
namespace {

using namespace dds;

Result<void> checkBytes(const Layout& layout, int faces, int levels, const DecodeLimits& limits) {
    std::uint64_t bytes = 0;
    for (int i = 0; i < levels; ++i) {
        const Level level = layout.at(0, i);
        bytes += static_cast<std::uint64_t>(faces) *
                 layout.format.decodedBytes(level.width, level.height, level.depth);
    }
    if (bytes > limits.maxBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("DDS: at most {0} bytes are decoded, the file has {1}", limits.maxBytes, bytes));
    return {};
}

Surface outlineOf(const Format& format, const Level& level) {
    if (const MaskedPixels* masked = std::get_if<MaskedPixels>(&format.pixels))
        return Image{masked->decoded, level.width, level.height, level.depth, {}};
    return BlockImage{std::get<BlockFormat>(format.pixels), level.width, level.height, level.depth, {}};
}

Surface readSurface(ByteView file, const Format& format, const Level& level) {
    const ByteView data = partOf(file, level.offset, level.size);
    if (const MaskedPixels* masked = std::get_if<MaskedPixels>(&format.pixels)) {
        Image image = Image::uninitialised(masked->decoded, level.width, level.height, level.depth);
        unpackPixels(*masked, data, image);
        return image;
    }
    BlockImage image = BlockImage::uninitialised(std::get<BlockFormat>(format.pixels), level.width,
                                                 level.height, level.depth);
    std::memcpy(image.blocks.data(), data.data(), data.size());
    return image;
}

bool saysAlpha(const Header& header) {
    const std::uint32_t mode = header.miscFlags2 & alphaModeMask;
    return header.extended() ? mode == alphaStraight || mode == alphaPremultiplied
                             : (header.formatFlags & formatAlphaPixels) != 0;
}

/// Decides between DXT1 and DXT1 with 1-bit alpha.
void settleDxt1(ByteView file, const Layout& layout, TextureImage& texture) {
    if (texture.alpha == AlphaMeaning::None)
        return;
    bool alpha = saysAlpha(readHeader(file));
    for (int face = 0; face < texture.layers * texture.faces; ++face)
        for (int i = 0; i < texture.levels && !alpha; ++i) {
            const Level level = layout.at(face, i);
            alpha = hasPunchThrough(partOf(file, level.offset, level.size), level.width, level.height,
                                    level.depth);
        }
    if (!alpha)
        texture.alpha = AlphaMeaning::None;
    else
        for (Surface& surface : texture.surfaces)
            std::get<BlockImage>(surface).format = BlockFormat::Dxt1Alpha;
}

} // namespace

Result<TextureImage> decodeDds(ByteView file, const DecodeLimits& limits) {
    Findings findings;
    const Result<Layout> layout = planLayout(file, limits, findings);
    if (!layout)
        return fail(layout.error());
    const Result<int> levels = wholeLevels(*layout, file.size(), findings);
    if (!levels)
        return fail(levels.error());
    if (std::holds_alternative<UnreadPixels>(layout->format.pixels))
        return fail(ErrorCode::Unsupported,
                    Sentence("DDS: {0} is not read; BC1 to BC5 and unsigned formats of at most 32 bits a "
                             "pixel are",
                             layout->format.name));
    const int layers = limits.everything ? static_cast<int>(layout->elements) : 1;
    const int faces = layers * layout->faces; // of all layers
    if (const Result<void> checked = checkBytes(*layout, faces, *levels, limits); !checked)
        return fail(checked.error());

    try {
        TextureImage texture;
        texture.format = "DDS";
        texture.layers = layers;
        texture.faces = layout->faces;
        texture.levels = *levels;
        texture.topFirst = true;
        texture.fileTopFirst = true;
        texture.srgb = layout->format.srgb;
        texture.alpha = layout->format.alpha;
        if (const MaskedPixels* masked = std::get_if<MaskedPixels>(&layout->format.pixels))
            texture.componentBits = std::max(texture.componentBits, masked->widest());
        for (int face = 0; face < faces; ++face)
            for (int level = 0; level < texture.levels; ++level)
                texture.surfaces.push_back(limits.pixels
                                               ? readSurface(file, layout->format, layout->at(face, level))
                                               : outlineOf(layout->format, layout->at(face, level)));
        if (const BlockFormat* block = std::get_if<BlockFormat>(&layout->format.pixels);
            block != nullptr && *block == BlockFormat::Dxt1)
            settleDxt1(file, *layout, texture);
        for (Finding& finding : findings)
            (finding.isFault ? texture.notes : texture.remarks).push_back(std::move(finding.sentence));
        return texture;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    Sentence("DDS: not enough memory for what the file's {0} bytes hold", file.size()));
    }
}

} // namespace texplorer
