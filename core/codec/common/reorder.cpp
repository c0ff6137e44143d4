#include "texplorer/codec/common/reorder.h"

#if defined(__x86_64__) || defined(__i386__)
#include <tmmintrin.h>
#define TEXPLORER_SSSE3 1
#endif

namespace texplorer {

void reorderScalar(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order,
                   std::size_t components) {
    for (; count > 0; --count, from += 4, to += components)
        for (std::size_t i = 0; i < components; ++i)
            to[i] = from[order[i]];
}

#ifdef TEXPLORER_SSSE3

namespace {

// Four pixels a step. Of three components the step's last four bytes are zeros that the next step overwrites,
// which is why it stops while two pixels are left behind it:
//
//   from   b0 g0 r0 x0 b1 g1 r1 x1 b2 g2 r2 x2 b3 g3 r3 x3
//   to     r0 g0 b0 r1 g1 b1 r2 g2 b2 r3 g3 b3 |  0  0  0  0
template<std::size_t Components>
__attribute__((target("ssse3"))) void reorderSsse3(const std::byte* from, std::byte* to, std::size_t count,
                                                   const ByteOrder& order) {
    alignas(16) std::array<std::int8_t, 16> places{};
    places.fill(-1); // gives 0
    for (std::size_t pixel = 0; pixel < 4; ++pixel)
        for (std::size_t i = 0; i < Components; ++i)
            places[Components * pixel + i] = static_cast<std::int8_t>(4 * pixel + order[i]);
    const __m128i shuffle = _mm_load_si128(reinterpret_cast<const __m128i*>(places.data()));
    constexpr std::size_t step = 4;
    constexpr std::size_t behind = Components == 4 ? 0 : 2;
#pragma GCC unroll 4
    for (; count >= step + behind; count -= step, from += 4 * step, to += Components * step) {
        const __m128i pixels = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_shuffle_epi8(pixels, shuffle));
    }
    reorderScalar(from, to, count, order, Components);
}

} // namespace

void reorderFourToFour(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order) {
    if (__builtin_cpu_supports("ssse3"))
        reorderSsse3<4>(from, to, count, order);
    else
        reorderScalar(from, to, count, order, 4);
}

void reorderFourToThree(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order) {
    if (__builtin_cpu_supports("ssse3"))
        reorderSsse3<3>(from, to, count, order);
    else
        reorderScalar(from, to, count, order, 3);
}

#else

void reorderFourToFour(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order) {
    reorderScalar(from, to, count, order, 4);
}

void reorderFourToThree(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order) {
    reorderScalar(from, to, count, order, 3);
}

#endif

} // namespace texplorer
