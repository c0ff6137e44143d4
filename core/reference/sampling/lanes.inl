// TEXPLORER_LANES numbers at a time, with the vector extension that GCC and Clang have on every processor.
// Each lane is computed exactly as a float alone would be. A text without a namespace and without a guard,
// because it is compiled once for each number of lanes: see lanes.h and kernel.h.

inline constexpr int laneCount = TEXPLORER_LANES;
using Floats = float __attribute__((vector_size(4 * TEXPLORER_LANES)));
using Ints = std::int32_t __attribute__((vector_size(4 * TEXPLORER_LANES))); ///< as a mask: -1 where it holds
using Color = float __attribute__((vector_size(16)));                        ///< of one pixel
using ColorBits = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline Floats floats(float value) {
    return value - Floats{};
}
[[nodiscard]] inline Ints ints(int value) {
    return value - Ints{};
}
/// 0, 1, 2, …
[[nodiscard]] inline Ints laneNumbers() {
#if TEXPLORER_LANES == 8
    return Ints{0, 1, 2, 3, 4, 5, 6, 7};
#else
    return Ints{0, 1, 2, 3};
#endif
}

template<class Lanes, class T>
[[nodiscard]] Lanes loadAs(const T* from) {
    static_assert(sizeof(T) == 4 || sizeof(T) == 16 || sizeof(T) == sizeof(Lanes));
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
[[nodiscard]] inline Floats load(const float* from) {
    return loadAs<Floats>(from);
}
[[nodiscard]] inline Color loadColor(const glm::vec4* color) {
    return loadAs<Color>(color);
}
[[nodiscard]] inline Color loadColor(const glm::vec4& color) {
    return loadAs<Color>(&color);
}
template<class Lanes, class T>
void store(Lanes lanes, T* to) {
    static_assert(sizeof(T) == 4 || sizeof(T) == 16 || sizeof(T) == sizeof(Lanes));
    std::memcpy(to, &lanes, sizeof lanes);
}

[[nodiscard]] inline Floats toFloats(Ints values) {
    return __builtin_convertvector(values, Floats);
}
/// Towards 0. What no int can hold gives an unspecified number.
[[nodiscard]] inline Ints truncated(Floats values) {
    return __builtin_convertvector(values, Ints);
}

/// A lane of `a` where `a` is less, else of `b`: with a NaN, that of `b`.
[[nodiscard]] inline Floats lesser(Floats a, Floats b) {
#if TEXPLORER_LANES == 8
    return _mm256_min_ps(a, b);
#elif defined(__SSE2__)
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}
[[nodiscard]] inline Floats greater(Floats a, Floats b) {
#if TEXPLORER_LANES == 8
    return _mm256_max_ps(a, b);
#elif defined(__SSE2__)
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}

[[nodiscard]] inline Floats rooted(Floats values) {
#if TEXPLORER_LANES == 8
    return _mm256_sqrt_ps(values);
#elif defined(__SSE2__)
    return _mm_sqrt_ps(values);
#else
    for (int i = 0; i < laneCount; ++i)
        values[i] = std::sqrt(values[i]);
    return values;
#endif
}

/// A mask with one bit a lane, the first the lowest.
[[nodiscard]] inline std::uint32_t bitsOf(Ints mask) {
#if TEXPLORER_LANES == 8
    return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__SSE2__)
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    const auto bit = [mask](int lane) { return static_cast<std::uint32_t>(mask[lane]) & 1U << lane; };
    return bit(0) | bit(1) | bit(2) | bit(3);
#endif
}
[[nodiscard]] inline bool any(Ints mask) {
    return bitsOf(mask) != 0;
}
[[nodiscard]] inline bool all(Ints mask) {
    return !any(~mask);
}

[[nodiscard]] inline Floats magnitude(Floats values) {
    return reinterpret_cast<Floats>(reinterpret_cast<Ints>(values) & ints(0x7FFFFFFF));
}

/// Neither NaN nor infinite.
[[nodiscard]] inline Ints isFinite(Floats values) {
    return magnitude(values) <= floats(std::numeric_limits<float>::max());
}

/// std::floor of numbers between -2^31 and 2^31.
[[nodiscard]] inline Floats flooredSmall(Floats values) {
#if TEXPLORER_LANES == 8
    return _mm256_floor_ps(values);
#else
    const Floats whole = toFloats(truncated(values));
    return whole > values ? whole - 1.0F : whole;
#endif
}
/// std::floor of any number that is finite: from 2^23 on they are whole.
[[nodiscard]] inline Floats floored(Floats values) {
    return magnitude(values) < floats(0x1p23F) ? flooredSmall(values) : values;
}

/// The logarithm with base 2, at most 4 units in the last place off and exact for powers of two. Minus
/// infinity for 0 and for what is too small to have all its digits (below 2^-126); the argument is neither
/// negative nor infinite nor NaN.
[[nodiscard]] inline Floats logarithms2(Floats values) {
    // values = 2^exponent (1 + f), with 1 + f between the roots of 1/2 and 2.
    constexpr std::int32_t rootOfHalf = 0x3F3504F3;
    const Ints bits = reinterpret_cast<Ints>(values);
    const Ints exponents = (bits - rootOfHalf) >> 23;
    const Floats f = reinterpret_cast<Floats>(bits - (exponents << 23)) - 1.0F;
    // The minimax polynomial for log2(1 + f) / f, relative error 2.6e-8. Summed up in pairs, so that few
    // operations wait for each other.
    const Floats f2 = f * f;
    const Floats f4 = f2 * f2;
    const Floats low = (1.4426950216293335F - 0.7213473320007324F * f) +
                       f2 * (0.48091062903404236F - 0.3607036769390106F * f);
    const Floats high = (0.28791624307632446F - 0.23894494771957397F * f) +
                        f2 * (0.21571584045886993F - 0.20726893842220306F * f);
    const Floats p = low + f4 * (high + f4 * 0.1258353739976883F);
    const Floats result = toFloats(exponents) + f * p;
    return values < std::numeric_limits<float>::min() ? floats(-std::numeric_limits<float>::infinity())
                                                      : result;
}
