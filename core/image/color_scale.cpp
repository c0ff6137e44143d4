#include "texplorer/image/color_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace texplorer {

std::array<std::uint8_t, 4> viridis(float share) {
    using Color = std::array<float, 3>;
    constexpr std::array colors{Color{68, 1, 84},    Color{72, 40, 120},  Color{62, 74, 137},
                                Color{49, 104, 142}, Color{38, 130, 142}, Color{31, 158, 137},
                                Color{53, 183, 121}, Color{109, 205, 89}, Color{180, 222, 44},
                                Color{253, 231, 37}};
    const float place = (share > 0 ? std::min(share, 1.0F) : 0) * static_cast<float>(colors.size() - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    std::array<std::uint8_t, 4> result{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c) {
        const float value =
            std::lerp(colors[first][c], colors[first + 1][c], place - static_cast<float>(first));
        result[c] = static_cast<std::uint8_t>(std::lround(value));
    }
    return result;
}

} // namespace texplorer
