#pragma once

#include <cstddef>
#include <cstring>
#include <span>

namespace texplorer {

/// A vertical or horizontal filter for four pixels at once. Every pixel adds the same products in the same
/// order, so its sum doesn't depend on where a tile begins. `width` is rounded up to a multiple of 8: so many
/// floats are written, and as many read beyond each tap. out[x] is the sum of taps[k] * in[x + k * step].
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

/// How many floats a row of so many pixels takes where filterRow writes or reads it.
[[nodiscard]] constexpr int paddedWidth(int width) {
    return (width + 7) / 8 * 8;
}

} // namespace texplorer
