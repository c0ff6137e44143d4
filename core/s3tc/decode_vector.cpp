// A block's palette fits into one register, and a byte shuffle looks up four texels at once.

#include "texplorer/s3tc/decode_rows.h"

#if defined(__x86_64__)

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <tmmintrin.h>

#define TEXPLORER_SSSE3 [[gnu::target("ssse3")]]

namespace texplorer {
namespace {

using Bytes16 = __m128i;

/// For each byte of four 2-bit codes: which bytes of a palette of four Rgba8 colours make the four texels.
struct ColorLookup {
    alignas(16) std::array<std::array<std::uint8_t, 16>, 256> rows{};

    constexpr ColorLookup() {
        for (unsigned codes = 0; codes < 256; ++codes)
            for (unsigned i = 0; i < 16; ++i)
                rows[codes][i] = static_cast<std::uint8_t>(4 * (codes >> (2 * (i / 4)) & 3) + i % 4);
    }
};

constexpr ColorLookup colorLookup;

TEXPLORER_SSSE3 Bytes16 loadBytes(const void* bytes) {
    return _mm_loadu_si128(static_cast<const Bytes16*>(bytes));
}

TEXPLORER_SSSE3 Bytes16 load8(const void* bytes) {
    return _mm_loadl_epi64(static_cast<const Bytes16*>(bytes));
}

TEXPLORER_SSSE3 void store(void* bytes, Bytes16 value) {
    _mm_storeu_si128(static_cast<Bytes16*>(bytes), value);
}

enum class Colors {
    Opaque,       ///< DXT1
    PunchThrough, ///< DXT1 with 1-bit alpha
    WithoutAlpha, ///< four colours in any order, and alpha 0, which the caller fills in
};

/// The four colours of a block as Rgba8. Works on two colours of four 16-bit lanes: r g b a, r g b a.
template<Colors kind>
TEXPLORER_SSSE3 Bytes16 colorPalette(const std::byte* block) {
    std::uint32_t both = 0;
    std::memcpy(&both, block, 4);
    const Bytes16 words = _mm_cvtsi32_si128(static_cast<int>(both));
    const Bytes16 spread =
        _mm_unpacklo_epi64(_mm_shufflelo_epi16(words, 0x00), _mm_shufflelo_epi16(words, 0x55));
    const Bytes16 fields =
        _mm_and_si128(spread, _mm_setr_epi16(-0x0800, 0x07E0, 0x001F, 0, -0x0800, 0x07E0, 0x001F, 0));
    // Each field to the top of its lane, then its 8 bits are the field and its own top bits after it.
    const Bytes16 top = _mm_mullo_epi16(fields, _mm_setr_epi16(1, 32, 2048, 0, 1, 32, 2048, 0));
    const Bytes16 repeated = _mm_mulhi_epu16(top, _mm_setr_epi16(8, 4, 8, 0, 8, 4, 8, 0));
    Bytes16 ends = _mm_or_si128(_mm_srli_epi16(top, 8), repeated);
    if constexpr (kind != Colors::WithoutAlpha)
        ends = _mm_or_si128(ends, _mm_setr_epi16(0, 0, 0, 255, 0, 0, 0, 255));
    const Bytes16 swapped = _mm_shuffle_epi32(ends, 0x4E);
    const Bytes16 sum = _mm_add_epi16(ends, swapped);
    // x / 3 for x up to 765 is x * 21846 / 65536.
    const Bytes16 thirds = _mm_mulhi_epu16(_mm_add_epi16(sum, ends), _mm_set1_epi16(21846));
    if constexpr (kind == Colors::WithoutAlpha)
        return _mm_packus_epi16(ends, thirds);
    const Bytes16 half = _mm_and_si128(_mm_srli_epi16(sum, 1), _mm_setr_epi32(-1, -1, 0, 0));
    const Bytes16 black =
        kind == Colors::Opaque ? _mm_setr_epi16(0, 0, 0, 0, 0, 0, 0, 255) : _mm_setzero_si128();
    const Bytes16 fourColors = _mm_set1_epi32((both & 0xFFFF) > both >> 16 ? -1 : 0);
    return _mm_packus_epi16(ends, _mm_or_si128(_mm_and_si128(fourColors, thirds),
                                               _mm_andnot_si128(fourColors, _mm_or_si128(half, black))));
}

TEXPLORER_SSSE3 Bytes16 colorRow(Bytes16 palette, const std::byte* block, std::size_t row) {
    const auto codes = std::to_integer<std::size_t>(block[4 + row]);
    return _mm_shuffle_epi8(palette, loadBytes(colorLookup.rows[codes].data()));
}

/// 16 alphas of 4 bits as bytes.
TEXPLORER_SSSE3 Bytes16 nibbles(const std::byte* block) {
    const Bytes16 packed = load8(block);
    const Bytes16 low = _mm_set1_epi8(15);
    const Bytes16 texels =
        _mm_unpacklo_epi8(_mm_and_si128(packed, low), _mm_and_si128(_mm_srli_epi16(packed, 4), low));
    return _mm_or_si128(texels, _mm_slli_epi16(texels, 4));
}

/// How the eight values of a block come from its two: (a * first + b * second) / divisor + added.
struct ValueWeights {
    alignas(16) std::array<std::int16_t, 8> first;
    alignas(16) std::array<std::int16_t, 8> second;
    std::int16_t reciprocal; ///< 65536 / divisor, rounded up: exact for the numbers that occur here
    alignas(16) std::array<std::int16_t, 8> added;
};

constexpr std::array valueWeights{
    ValueWeights{{5, 0, 4, 3, 2, 1, 0, 0}, {0, 5, 1, 2, 3, 4, 0, 0}, 13108, {0, 0, 0, 0, 0, 0, 0, 255}},
    ValueWeights{{7, 0, 6, 5, 4, 3, 2, 1}, {0, 7, 1, 2, 3, 4, 5, 6}, 9363, {}},
};

TEXPLORER_SSSE3 Bytes16 unsignedPalette(const std::byte* block) {
    const int a = std::to_integer<int>(block[0]);
    const int b = std::to_integer<int>(block[1]);
    const ValueWeights& weights = valueWeights[a > b ? 1 : 0];
    const Bytes16 first =
        _mm_mullo_epi16(_mm_set1_epi16(static_cast<short>(a)), loadBytes(weights.first.data()));
    const Bytes16 second =
        _mm_mullo_epi16(_mm_set1_epi16(static_cast<short>(b)), loadBytes(weights.second.data()));
    const Bytes16 quotient =
        _mm_mulhi_epu16(_mm_add_epi16(first, second), _mm_set1_epi16(weights.reciprocal));
    return _mm_packus_epi16(_mm_add_epi16(quotient, loadBytes(weights.added.data())), _mm_setzero_si128());
}

/// The same for -127 to 127, which become 0 to 255: divisions that round towards zero are plain arithmetic's.
TEXPLORER_SSSE3 Bytes16 signedPalette(const std::byte* block) {
    const int first{std::to_integer<std::int8_t>(block[0])};  // NOLINT(bugprone-signed-char-misuse): a number
    const int second{std::to_integer<std::int8_t>(block[1])}; // NOLINT(bugprone-signed-char-misuse)
    const int a = std::max(-127, first);
    const int b = std::max(-127, second);
    const ValueWeights& weights = valueWeights[first > second ? 1 : 0];
    const int divisor = first > second ? 7 : 5;
    alignas(16) std::array<std::uint8_t, 16> palette{};
    for (std::size_t i = 0; i < 8; ++i) {
        const int value = (a * weights.first[i] + b * weights.second[i]) / divisor;
        palette[i] = static_cast<std::uint8_t>(((value + 127) * 255 + 127) / 254);
    }
    if (first <= second) {
        palette[6] = 0;
        palette[7] = 255;
    }
    return loadBytes(palette.data());
}

/// 16 values with codes of 3 bits as bytes. Texel k's code starts at bit 3k, so two bytes hold it whole; a
/// multiplication pushes what is above it out of the lane.
TEXPLORER_SSSE3 Bytes16 valuesOf(const std::byte* block, Bytes16 palette) {
    const Bytes16 codes = load8(block); // bytes 2 to 7 hold the codes
    const Bytes16 bytesOfFirst = _mm_setr_epi8(2, 3, 2, 3, 2, 3, 3, 4, 3, 4, 3, 4, 4, 5, 4, 5);
    const Bytes16 bytesOfSecond = _mm_setr_epi8(5, 6, 5, 6, 5, 6, 6, 7, 6, 7, 6, 7, 7, -1, 7, -1);
    const Bytes16 push = _mm_setr_epi16(1 << 13, 1 << 10, 1 << 7, 1 << 12, 1 << 9, 1 << 6, 1 << 11, 1 << 8);
    const Bytes16 first = _mm_srli_epi16(_mm_mullo_epi16(_mm_shuffle_epi8(codes, bytesOfFirst), push), 13);
    const Bytes16 second = _mm_srli_epi16(_mm_mullo_epi16(_mm_shuffle_epi8(codes, bytesOfSecond), push), 13);
    return _mm_shuffle_epi8(palette, _mm_packus_epi16(first, second));
}

template<bool isSigned>
TEXPLORER_SSSE3 Bytes16 valuesOf(const std::byte* block) {
    return valuesOf(block, isSigned ? signedPalette(block) : unsignedPalette(block));
}

/// Four of 16 bytes, each into the top byte of a texel.
TEXPLORER_SSSE3 Bytes16 alphaRow(Bytes16 alphas, int row) {
    const Bytes16 places = _mm_setr_epi8(-1, -1, -1, 0, -1, -1, -1, 1, -1, -1, -1, 2, -1, -1, -1, 3);
    const Bytes16 step = _mm_slli_epi32(_mm_set1_epi32(4 * row), 24);
    return _mm_shuffle_epi8(alphas, _mm_add_epi8(places, step));
}

template<Colors kind>
TEXPLORER_SSSE3 void decodeDxt1(const std::byte* blocks, std::size_t count, std::byte* rgba,
                                std::size_t rowBytes) {
    for (std::size_t i = 0; i < count; ++i, blocks += 8, rgba += 16) {
        const Bytes16 palette = colorPalette<kind>(blocks);
        for (std::size_t row = 0; row < 4; ++row)
            store(rgba + row * rowBytes, colorRow(palette, blocks, row));
    }
}

template<bool fourBits>
TEXPLORER_SSSE3 void decodeWithAlpha(const std::byte* blocks, std::size_t count, std::byte* rgba,
                                     std::size_t rowBytes) {
    for (std::size_t i = 0; i < count; ++i, blocks += 16, rgba += 16) {
        const Bytes16 palette = colorPalette<Colors::WithoutAlpha>(blocks + 8);
        const Bytes16 alphas = fourBits ? nibbles(blocks) : valuesOf<false>(blocks);
        for (std::size_t row = 0; row < 4; ++row)
            store(rgba + row * rowBytes,
                  _mm_or_si128(colorRow(palette, blocks + 8, row), alphaRow(alphas, static_cast<int>(row))));
    }
}

template<bool isSigned>
TEXPLORER_SSSE3 void decodeBc4(const std::byte* blocks, std::size_t count, std::byte* rgba,
                               std::size_t rowBytes) {
    const Bytes16 opaque = _mm_set1_epi32(static_cast<int>(0xFF000000U));
    for (std::size_t i = 0; i < count; ++i, blocks += 8, rgba += 16) {
        const Bytes16 greys = valuesOf<isSigned>(blocks);
        for (std::size_t row = 0; row < 4; ++row) {
            const Bytes16 places = _mm_setr_epi8(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
            const Bytes16 step = _mm_set1_epi8(static_cast<char>(4 * row));
            store(rgba + row * rowBytes,
                  _mm_or_si128(_mm_shuffle_epi8(greys, _mm_add_epi8(places, step)), opaque));
        }
    }
}

template<bool isSigned>
TEXPLORER_SSSE3 void decodeBc5(const std::byte* blocks, std::size_t count, std::byte* rgba,
                               std::size_t rowBytes) {
    const Bytes16 noBlueAndOpaque = _mm_set1_epi16(static_cast<short>(0xFF00));
    for (std::size_t i = 0; i < count; ++i, blocks += 16, rgba += 16) {
        const Bytes16 reds = valuesOf<isSigned>(blocks);
        const Bytes16 greens = valuesOf<isSigned>(blocks + 8);
        const Bytes16 upper = _mm_unpacklo_epi8(reds, greens);
        const Bytes16 lower = _mm_unpackhi_epi8(reds, greens);
        store(rgba, _mm_unpacklo_epi16(upper, noBlueAndOpaque));
        store(rgba + rowBytes, _mm_unpackhi_epi16(upper, noBlueAndOpaque));
        store(rgba + 2 * rowBytes, _mm_unpacklo_epi16(lower, noBlueAndOpaque));
        store(rgba + 3 * rowBytes, _mm_unpackhi_epi16(lower, noBlueAndOpaque));
    }
}

} // namespace

RowDecoder vectorRowDecoder(BlockFormat format) {
    if (!__builtin_cpu_supports("ssse3"))
        return nullptr;
    switch (format) {
    case BlockFormat::Dxt1:
        return decodeDxt1<Colors::Opaque>;
    case BlockFormat::Dxt1Alpha:
        return decodeDxt1<Colors::PunchThrough>;
    case BlockFormat::Dxt3:
        return decodeWithAlpha<true>;
    case BlockFormat::Dxt5:
        return decodeWithAlpha<false>;
    case BlockFormat::Bc4:
        return decodeBc4<false>;
    case BlockFormat::Bc4Signed:
        return decodeBc4<true>;
    case BlockFormat::Bc5:
        return decodeBc5<false>;
    case BlockFormat::Bc5Signed:
        return decodeBc5<true>;
    }
    return nullptr;
}

} // namespace texplorer

#else

namespace texplorer {

RowDecoder vectorRowDecoder(BlockFormat) {
    return nullptr;
}

} // namespace texplorer

#endif
