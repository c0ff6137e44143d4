#include "texplorer/image/mip_colors.h"

#include <iterator>

namespace texplorer {

std::array<std::uint8_t, 4> mipColor(int level) {
    constexpr std::array<std::uint8_t, 4> colors[] = {
        {230, 40, 40, 255},  {245, 140, 30, 255}, {250, 225, 50, 255}, {60, 180, 75, 255},
        {60, 200, 220, 255}, {50, 90, 220, 255},  {145, 70, 200, 255}, {255, 255, 255, 255},
    };
    return colors[static_cast<unsigned>(level) % std::size(colors)];
}

} // namespace texplorer
