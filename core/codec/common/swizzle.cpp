#include "texplorer/codec/common/swizzle.h"

#if defined(__x86_64__) || defined(__i386__)
#include <tmmintrin.h>
#define TEXPLORER_SSSE3 1
#endif

namespace texplorer {

void swapRedBlueScalar(const std::byte* from, std::byte* to, std::size_t count) {
    for (const std::byte* end = from + 3 * count; from != end; from += 3, to += 3) {
        to[0] = from[2];
        to[1] = from[1];
        to[2] = from[0];
    }
}

void swapRedBlueAlphaScalar(const std::byte* from, std::byte* to, std::size_t count) {
    for (const std::byte* end = from + 4 * count; from != end; from += 4, to += 4) {
        to[0] = from[2];
        to[1] = from[1];
        to[2] = from[0];
        to[3] = from[3];
    }
}

#ifdef TEXPLORER_SSSE3

namespace {

// Five pixels a step. The sixteenth byte is the next pixel's, moved along as it is and overwritten by the
// next step:
//
//   from   b0 g0 r0 b1 g1 r1 b2 g2 r2 b3 g3 r3 b4 g4 r4 | b5
//   to     r0 g0 b0 r1 g1 b1 r2 g2 b2 r3 g3 b3 r4 g4 b4 | b5
__attribute__((target("ssse3"))) void swapRedBlueSsse3(const std::byte* from, std::byte* to,
                                                       std::size_t count) {
    const __m128i order = _mm_setr_epi8(2, 1, 0, 5, 4, 3, 8, 7, 6, 11, 10, 9, 14, 13, 12, 15);
    // Unrolled, because its own counting would cost the loop as much as the shuffle does.
#pragma GCC unroll 4
    for (; count >= 6; count -= 5, from += 15, to += 15) {
        const __m128i pixels = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_shuffle_epi8(pixels, order));
    }
    swapRedBlueScalar(from, to, count);
}

// Four pixels a step, and nothing left over.
__attribute__((target("ssse3"))) void swapRedBlueAlphaSsse3(const std::byte* from, std::byte* to,
                                                            std::size_t count) {
    const __m128i order = _mm_setr_epi8(2, 1, 0, 3, 6, 5, 4, 7, 10, 9, 8, 11, 14, 13, 12, 15);
#pragma GCC unroll 4
    for (; count >= 4; count -= 4, from += 16, to += 16) {
        const __m128i pixels = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_shuffle_epi8(pixels, order));
    }
    swapRedBlueAlphaScalar(from, to, count);
}

} // namespace

void swapRedBlue(const std::byte* from, std::byte* to, std::size_t count) {
    if (__builtin_cpu_supports("ssse3"))
        swapRedBlueSsse3(from, to, count);
    else
        swapRedBlueScalar(from, to, count);
}

void swapRedBlueAlpha(const std::byte* from, std::byte* to, std::size_t count) {
    if (__builtin_cpu_supports("ssse3"))
        swapRedBlueAlphaSsse3(from, to, count);
    else
        swapRedBlueAlphaScalar(from, to, count);
}

#else

void swapRedBlue(const std::byte* from, std::byte* to, std::size_t count) {
    swapRedBlueScalar(from, to, count);
}

void swapRedBlueAlpha(const std::byte* from, std::byte* to, std::size_t count) {
    swapRedBlueAlphaScalar(from, to, count);
}

#endif

} // namespace texplorer
