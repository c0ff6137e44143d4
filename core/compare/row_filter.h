#pragma once

#include <cstddef>
#include <cstring>
#include <span>

namespace texplorer {

/// A vertical or horizontal filter for four pixels at once: out[x] is the sum of taps[k] * in[x + k * step].
/// Every pixel adds the same products in the same order, so the result does not depend on the tiles. `width`
/// is rounded up to a multiple of 8: so many floats are written, and read beyond each tap.
inline void filterRow(const float* in, std::ptrdiff_t step, std::span<const float> taps, float* out,
                      int width) {
    using Floats [[gnu::vector_size(16)]] = float;
    const auto load = [](const float* from) {
        Floats floats;
        std::memcpy(&floats, from, sizeof floats);
        return floats;
    };
    for (int x = 0; x < width; x += 8) {
        Floats first{};
        Floats second{};
        const float* from = in + x;
        for (const float tap : taps) {
            first += load(from) * tap;
            second += load(from + 4) * tap;
            from += step;
        }
        std::memcpy(out + x, &first, sizeof first);
        std::memcpy(out + x + 4, &second, sizeof second);
    }
}

/// The number of floats in a row of so many pixels for filterRow.
[[nodiscard]] constexpr int paddedWidth(int width) {
    return (width + 7) / 8 * 8;
}

} // namespace texplorer
