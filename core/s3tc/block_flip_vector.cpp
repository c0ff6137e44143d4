// 64 bytes of blocks at a time (AVX2). Where AVX-512VL is, the compiler makes one instruction of each two
// logical ones.

#include "texplorer/s3tc/block_flip.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define TEXPLORER_AVX2 [[gnu::target("avx2")]]
#define TEXPLORER_AVX512 [[gnu::target("avx512vl")]]
// Compiled for the same processor as the calling function.
#define TEXPLORER_INLINE [[gnu::target("avx2"), gnu::always_inline]] inline

namespace texplorer {
namespace {

using Vector = __m256i;

TEXPLORER_INLINE Vector loadVector(const std::byte* bytes) {
    return _mm256_loadu_si256(reinterpret_cast<const Vector*>(bytes));
}

TEXPLORER_INLINE Vector loadTwice(const void* bytes) {
    return _mm256_broadcastsi128_si256(_mm_loadu_si128(static_cast<const __m128i*>(bytes)));
}

TEXPLORER_INLINE void store(std::byte* bytes, Vector value) {
    _mm256_storeu_si256(reinterpret_cast<Vector*>(bytes), value);
}

/// BlockFlip in registers. The number of parts is known to the compiler, so that the loops over them unroll.
template<std::size_t partCount>
struct VectorFlip {
    Vector shuffle;
    Vector low[partCount + 1]; // one more: an array of none is no C++
    Vector shift[partCount + 1];

    TEXPLORER_INLINE explicit VectorFlip(const BlockFlip& flip)
        : shuffle(loadTwice(flip.shuffle.data())) {
        for (std::size_t i = 0; i < partCount; ++i) {
            low[i] = loadTwice(flip.parts[i].low.data());
            shift[i] = loadTwice(flip.parts[i].shift.data());
        }
    }

    [[nodiscard]] TEXPLORER_INLINE Vector operator()(Vector blocks) const {
        blocks = _mm256_shuffle_epi8(blocks, shuffle);
        for (std::size_t i = 0; i < partCount; ++i) {
            const Vector shifted = _mm256_srlv_epi64(blocks, shift[i]);
            const Vector differing = _mm256_and_si256(_mm256_xor_si256(shifted, blocks), low[i]);
            blocks =
                _mm256_xor_si256(blocks, _mm256_xor_si256(differing, _mm256_sllv_epi64(differing, shift[i])));
        }
        return blocks;
    }
};

/// Everything is loaded before anything is stored: rows that lie a multiple of 4096 bytes apart would
/// otherwise make each load wait for the store before it.
template<std::size_t partCount>
TEXPLORER_INLINE void swapAll(const BlockFlip& blockFlip, std::byte* first, std::byte* second,
                              std::size_t bytes) {
    const VectorFlip<partCount> flip(blockFlip);
    for (std::size_t i = 0; i < bytes; i += 64) {
        const Vector a0 = loadVector(first + i);
        const Vector a1 = loadVector(first + i + 32);
        const Vector b0 = loadVector(second + i);
        const Vector b1 = loadVector(second + i + 32);
        store(first + i, flip(b0));
        store(first + i + 32, flip(b1));
        store(second + i, flip(a0));
        store(second + i + 32, flip(a1));
    }
}

using SwapAll = void (*)(const BlockFlip& flip, std::byte* first, std::byte* second, std::size_t bytes);

template<std::size_t partCount>
TEXPLORER_AVX2 void swapAllAvx2(const BlockFlip& flip, std::byte* first, std::byte* second,
                                std::size_t bytes) {
    swapAll<partCount>(flip, first, second, bytes);
}

template<std::size_t partCount>
TEXPLORER_AVX512 void swapAllAvx512(const BlockFlip& flip, std::byte* first, std::byte* second,
                                    std::size_t bytes) {
    swapAll<partCount>(flip, first, second, bytes);
}

template<std::size_t partCount>
SwapAll swapAllHere() {
    return __builtin_cpu_supports("avx512vl") ? swapAllAvx512<partCount> : swapAllAvx2<partCount>;
}

} // namespace

std::size_t swapFlippedInVectors(const BlockFlip& flip, std::byte* first, std::byte* second,
                                 std::size_t bytes) {
    if (!__builtin_cpu_supports("avx2"))
        return 0;
    const std::size_t whole = bytes / 64 * 64;
    const SwapAll swap = flip.partCount == 0   ? swapAllHere<0>()
                         : flip.partCount == 1 ? swapAllHere<1>()
                                               : swapAllHere<4>();
    swap(flip, first, second, whole);
    return whole;
}

} // namespace texplorer

#else

namespace texplorer {

std::size_t swapFlippedInVectors(const BlockFlip&, std::byte*, std::byte*, std::size_t) {
    return 0;
}

} // namespace texplorer

#endif
