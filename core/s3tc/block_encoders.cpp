#include "texplorer/s3tc/block_encoders.h"

#include "texplorer/s3tc/decode.h"

#include <algorithm>
#include <array>
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

/// The sum of the squares over the components from `first` on.
int errorOf(const std::uint8_t* texels, const std::array<std::byte, 64>& decoded, std::size_t first,
            std::size_t count) {
    int sum = 0;
    for (std::size_t texel = 0; texel < 16; ++texel)
        for (std::size_t i = 4 * texel + first; i < 4 * texel + first + count; ++i) {
            const int difference = texels[i] - std::to_integer<int>(decoded[i]);
            sum += difference * difference;
        }
    return sum;
}

/// A half of a block, 8 bytes, that stands for components of its own.
struct BlockHalf {
    std::size_t component;
    std::size_t count;
};

constexpr std::array dxt1Halves{BlockHalf{0, 3}};
constexpr std::array alphaHalves{BlockHalf{3, 1}, BlockHalf{0, 3}};
constexpr std::array bc4Halves{BlockHalf{0, 1}};
constexpr std::array bc5Halves{BlockHalf{0, 1}, BlockHalf{1, 1}};

/// Each half of the block from whichever library comes nearer: libsquish's fits by clusters lose to stb_dxt
/// where colours lie close together.
template<BlockFormat format, const auto& halves, BlockEncoder one, BlockEncoder other>
void better(std::uint8_t* texels, std::byte* block) {
    std::array<std::uint8_t, 64> changed; // by the encoders
    std::array<std::byte, 16> blocks[2];
    std::array<std::byte, 64> decoded[2];
    for (std::size_t i = 0; i < 2; ++i) {
        std::copy_n(texels, changed.size(), changed.begin());
        (i == 0 ? one : other)(changed.data(), blocks[i].data());
        decodeBlock(format, blocks[i].data(), decoded[i].data());
    }
    for (std::size_t half = 0; half < halves.size(); ++half) {
        const auto error = [&](std::size_t i) {
            return errorOf(texels, decoded[i], halves[half].component, halves[half].count);
        };
        std::copy_n(blocks[error(1) < error(0) ? 1 : 0].begin() + static_cast<std::ptrdiff_t>(8 * half), 8,
                    block + 8 * half);
    }
}

/// stb_dxt knows of no holes.
void bestDxt1Alpha(std::uint8_t* texels, std::byte* block) {
    constexpr int flags = squish::kDxt1 | squish::kColourClusterFit;
    if (hasHoles(texels))
        squish::Compress(texels, block, flags);
    else
        better<BlockFormat::Dxt1, dxt1Halves, withSquishOpaque<flags>, quickDxt1<STB_DXT_HIGHQUAL>>(texels,
                                                                                                    block);
}

BlockEncoder bestEncoder(BlockFormat format) {
    constexpr int fit = squish::kColourClusterFit;
    switch (format) {
    case BlockFormat::Dxt1:
        return better<BlockFormat::Dxt1, dxt1Halves, withSquishOpaque<squish::kDxt1 | fit>,
                      quickDxt1<STB_DXT_HIGHQUAL>>;
    case BlockFormat::Dxt1Alpha:
        return bestDxt1Alpha;
    case BlockFormat::Dxt3:
        return better<BlockFormat::Dxt3, alphaHalves, withSquish<squish::kDxt3 | fit>,
                      quickDxt3<STB_DXT_HIGHQUAL>>;
    case BlockFormat::Dxt5:
        return better<BlockFormat::Dxt5, alphaHalves, withSquish<squish::kDxt5 | fit>,
                      quickDxt5<STB_DXT_HIGHQUAL>>;
    case BlockFormat::Bc4:
        return better<BlockFormat::Bc4, bc4Halves, withSquish<squish::kBc4>, fastBc4>;
    case BlockFormat::Bc5:
        return better<BlockFormat::Bc5, bc5Halves, withSquish<squish::kBc5>, fastBc5>;
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
