#include "texplorer/image/mean_color.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace texplorer {

glm::vec4 meanColor(const Image& image) {
    std::array<std::uint64_t, 4> sums{};
    for (std::size_t i = 0; i + 4 <= image.pixels.size(); i += 4) {
        for (std::size_t c = 0; c < 4; ++c)
            sums[c] += std::to_integer<std::uint64_t>(image.pixels[i + c]);
    }
    const auto most = 255 * static_cast<float>(std::max<std::size_t>(1, image.pixels.size() / 4));
    return glm::vec4(sums[0], sums[1], sums[2], sums[3]) / most;
}

} // namespace texplorer
