#include "core/s3tc/block_encoders.h"

#include <cstring> // which stb_dxt.h relies on

#define STB_DXT_STATIC
#define STB_DXT_IMPLEMENTATION
#include <squish.h>
#include <stb/stb_dxt.h>

namespace texplorer {
namespace {

std::uint8_t* bytesOf(std::byte* block) {
    return reinterpret_cast<std::uint8_t*>(block);
}

void makeOpaque(std::uint8_t* texels) {
    for (std::size_t i = 0; i < 16; ++i)
        texels[4 * i + 3] = 255;
}

bool hasHoles(const std::uint8_t* texels) {
    for (std::size_t i = 0; i < 16; ++i)
        if (texels[4 * i + 3] < 128)
            return true;
    return false;
}

// `mode` is stb_dxt's: how often it refines the end points.
template<int mode>
void quickDxt1(std::uint8_t* texels, std::byte* block) {
    makeOpaque(texels);
    stb_compress_dxt_block(bytesOf(block), texels, 0, mode);
}

/// stb_dxt knows of no holes: blocks with some are libsquish's.
template<int mode, int fit>
void quickDxt1Alpha(std::uint8_t* texels, std::byte* block) {
    if (hasHoles(texels))
        squish::Compress(texels, block, squish::kDxt1 | fit);
    else
        quickDxt1<mode>(texels, block);
}

template<int mode>
void quickDxt3(std::uint8_t* texels, std::byte* block) {
    for (std::size_t i = 0; i < 8; ++i) {
        const auto fourBits = [&](std::size_t texel) { return (texels[4 * texel + 3] * 15 + 127) / 255; };
        block[i] = static_cast<std::byte>(fourBits(2 * i) | fourBits(2 * i + 1) << 4);
    }
    quickDxt1<mode>(texels, block + 8);
}

template<int mode>
void quickDxt5(std::uint8_t* texels, std::byte* block) {
    stb_compress_dxt_block(bytesOf(block), texels, 1, mode);
}

void fastBc4(std::uint8_t* texels, std::byte* block) {
    std::uint8_t reds[16];
    for (std::size_t i = 0; i < 16; ++i)
        reds[i] = texels[4 * i];
    stb_compress_bc4_block(bytesOf(block), reds);
}

void fastBc5(std::uint8_t* texels, std::byte* block) {
    std::uint8_t redsAndGreens[32];
    for (std::size_t i = 0; i < 32; ++i)
        redsAndGreens[i] = texels[4 * (i / 2) + i % 2];
    stb_compress_bc5_block(bytesOf(block), redsAndGreens);
}

template<int flags>
void withSquish(std::uint8_t* texels, std::byte* block) {
    squish::Compress(texels, block, flags);
}

template<int flags>
void withSquishOpaque(std::uint8_t* texels, std::byte* block) {
    makeOpaque(texels);
    squish::Compress(texels, block, flags);
}

BlockEncoder bestEncoder(BlockFormat format) {
    constexpr int fit = squish::kColourClusterFit;
    switch (format) {
    case BlockFormat::Dxt1:
        return withSquishOpaque<squish::kDxt1 | fit>;
    case BlockFormat::Dxt1Alpha:
        return withSquish<squish::kDxt1 | fit>;
    case BlockFormat::Dxt3:
        return withSquish<squish::kDxt3 | fit>;
    case BlockFormat::Dxt5:
        return withSquish<squish::kDxt5 | fit>;
    case BlockFormat::Bc4:
        return withSquish<squish::kBc4>;
    case BlockFormat::Bc5:
        return withSquish<squish::kBc5>;
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5Signed:
        break;
    }
    return nullptr;
}

BlockEncoder fastEncoder(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
        return quickDxt1<STB_DXT_NORMAL>;
    case BlockFormat::Dxt1Alpha:
        return quickDxt1Alpha<STB_DXT_NORMAL, squish::kColourRangeFit>;
    case BlockFormat::Dxt3:
        return quickDxt3<STB_DXT_NORMAL>;
    case BlockFormat::Dxt5:
        return quickDxt5<STB_DXT_NORMAL>;
    case BlockFormat::Bc4:
        return fastBc4;
    case BlockFormat::Bc5:
        return fastBc5;
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5Signed:
        break;
    }
    return nullptr;
}

BlockEncoder normalEncoder(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
        return quickDxt1<STB_DXT_HIGHQUAL>;
    case BlockFormat::Dxt1Alpha:
        return quickDxt1Alpha<STB_DXT_HIGHQUAL, squish::kColourClusterFit>;
    case BlockFormat::Dxt3:
        return quickDxt3<STB_DXT_HIGHQUAL>;
    case BlockFormat::Dxt5:
        return quickDxt5<STB_DXT_HIGHQUAL>;
    case BlockFormat::Bc4:
    case BlockFormat::Bc5:
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5Signed:
        break;
    }
    return bestEncoder(format); // of one or two components it is quick
}

} // namespace

BlockEncoder blockEncoder(BlockFormat format, EncodeQuality quality) {
    switch (quality) {
    case EncodeQuality::Fast:
        return fastEncoder(format);
    case EncodeQuality::Normal:
        return normalEncoder(format);
    case EncodeQuality::Best:
        break;
    }
    return bestEncoder(format);
}

} // namespace texplorer
