#include "app/ui/widgets/palette.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

constexpr ImU32 paletteColor(unsigned hex, unsigned alpha = 255) {
    return IM_COL32(hex >> 16 & 255U, hex >> 8 & 255U, hex & 255U, alpha);
}

constexpr Palette darkPalette{
    .s = paletteColor(0xFF979B),
    .t = paletteColor(0x7EC874),
    .r = paletteColor(0x72ACFF),
    .q = paletteColor(0xAAB0B9),
    .chosen = paletteColor(0xFFD040),
    .probed = paletteColor(0x5EE4F4),
    .changed = paletteColor(0xC899DD),
    .problem = paletteColor(0xFF8B5D),
    .text = paletteColor(0xDEE2E8),
    .dim = paletteColor(0xA4ABB6),
    .faint = paletteColor(0x848C98),
    .keyword = paletteColor(0x7FB8BA),
    .uniform = paletteColor(0xCEBE90),
    .accent = paletteColor(0x7696BE),
    .outline = paletteColor(0xE1E6F0, 120),
    .blamed = paletteColor(0xFF8B5D, 60),
    .lit = paletteColor(0x7696BE, 100),
    .shade = paletteColor(0x0C0E12, 225),
    .ground = paletteColor(0x111317),
    .board = paletteColor(0x3E4249),
    .boardLight = paletteColor(0x545961),
    .panel = paletteColor(0x1E2127),
    .popup = paletteColor(0x22262D),
    .bar = paletteColor(0x181A1F),
    .title = paletteColor(0x2C3139),
    .field = paletteColor(0x31363F),
    .fieldHover = paletteColor(0x383E48),
    .fieldActive = paletteColor(0x39404A),
    .header = paletteColor(0x323944),
    .headerHover = paletteColor(0x38404D),
    .headerActive = paletteColor(0x3E4A5C),
    .selection = paletteColor(0x466084),
    .border = paletteColor(0x404650),
    .separator = paletteColor(0x343942),
    .grab = paletteColor(0x6A7384),
    .curtain = paletteColor(0x08090C, 140),
};

constexpr Palette lightPalette{
    .s = paletteColor(0xB91C2B),
    .t = paletteColor(0x255E27),
    .r = paletteColor(0x1954C3),
    .q = paletteColor(0x5A5A5A),
    .chosen = paletteColor(0x583800),
    .probed = paletteColor(0x006C80),
    .changed = paletteColor(0x691FA2),
    .problem = paletteColor(0xAC3F00),
    .text = paletteColor(0x1C2026),
    .dim = paletteColor(0x545B66),
    .faint = paletteColor(0x666D78),
    .keyword = paletteColor(0x006268),
    .uniform = paletteColor(0x745400),
    .accent = paletteColor(0x2F66A8),
    .outline = paletteColor(0x1E242E, 130),
    .blamed = paletteColor(0xAC3F00, 40),
    .lit = paletteColor(0x4A86CC, 80),
    .shade = paletteColor(0xFFFFFF, 225),
    .ground = paletteColor(0xFAFAFB),
    .board = paletteColor(0xC4C8CE),
    .boardLight = paletteColor(0xDCDFE4),
    .panel = paletteColor(0xEEF0F3),
    .popup = paletteColor(0xF8F9FA),
    .bar = paletteColor(0xE2E5EA),
    .title = paletteColor(0xD6DEE9),
    .field = paletteColor(0xFFFFFF),
    .fieldHover = paletteColor(0xE4EBF5),
    .fieldActive = paletteColor(0xDEE6F2),
    .header = paletteColor(0xD9E1EC),
    .headerHover = paletteColor(0xD3DCE8),
    .headerActive = paletteColor(0xC3D3E9),
    .selection = paletteColor(0xA9C7EC),
    .border = paletteColor(0x9AA1AC),
    .separator = paletteColor(0xC9CED6),
    .grab = paletteColor(0x838993),
    .curtain = paletteColor(0x30363F, 110),
};

constexpr Palette highContrastPalette{
    .s = paletteColor(0xFF9A95),
    .t = paletteColor(0x7EE674),
    .r = paletteColor(0x77A8FF),
    .q = paletteColor(0xBEBEBD),
    .chosen = paletteColor(0xFFDC40),
    .probed = paletteColor(0x46E6FF),
    .changed = paletteColor(0xD391DB),
    .problem = paletteColor(0xF88D53),
    .text = paletteColor(0xFFFFFF),
    .dim = paletteColor(0xD0D0D0),
    .faint = paletteColor(0xB4B4B4),
    .keyword = paletteColor(0x8FE3E6),
    .uniform = paletteColor(0xF0DCA0),
    .accent = paletteColor(0x6FB4FF),
    .outline = paletteColor(0xFFFFFF, 160),
    .blamed = paletteColor(0xF88D53, 70),
    .lit = paletteColor(0x6FB4FF, 90),
    .shade = paletteColor(0x000000, 240),
    .ground = paletteColor(0x000000),
    .board = paletteColor(0x303030),
    .boardLight = paletteColor(0x484848),
    .panel = paletteColor(0x000000),
    .popup = paletteColor(0x0A0A0A),
    .bar = paletteColor(0x242424),
    .title = paletteColor(0x1C1C1C),
    .field = paletteColor(0x1A1A1A),
    .fieldHover = paletteColor(0x1E1E1E),
    .fieldActive = paletteColor(0x1E1E1E),
    .header = paletteColor(0x1C1C1C),
    .headerHover = paletteColor(0x1E1E1E),
    .headerActive = paletteColor(0x1F3A5C),
    .selection = paletteColor(0x1F4A80),
    .border = paletteColor(0x909090),
    .separator = paletteColor(0x707070),
    .grab = paletteColor(0x8C8C8C),
    .curtain = paletteColor(0x000000, 170),
};

constexpr std::array palettes{&darkPalette, &lightPalette, &highContrastPalette}; // in the order of Theme
static_assert(palettes.size() == themeRows.size());

const Palette* inForce = &darkPalette; // global, like Dear ImGui's own style

} // namespace

const Palette& paletteOf(Theme theme) {
    return *palettes[static_cast<std::size_t>(theme)];
}

const Palette& palette() {
    return *inForce;
}

void usePalette(Theme theme) {
    inForce = &paletteOf(theme);
}

ImU32 componentColor(int component) {
    constexpr std::array colors{color::s, color::t, color::r, color::q};
    return colors[static_cast<std::size_t>(std::clamp(component, 0, 3))];
}

} // namespace texplorer::ui
