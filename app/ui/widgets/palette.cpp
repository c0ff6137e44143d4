#include "app/ui/widgets/palette.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

/// A colour as 0xRRGGBBAA in each theme.
struct PaletteRow {
    ImU32 Palette::*color;
    std::array<unsigned, themeRows.size()> themes; ///< in the order of Theme
};

constexpr std::array paletteRows{
    PaletteRow{&Palette::s, {0xFF979BFF, 0xB91C2BFF, 0xFF9A95FF}},
    PaletteRow{&Palette::t, {0x7EC874FF, 0x255E27FF, 0x7EE674FF}},
    PaletteRow{&Palette::r, {0x72ACFFFF, 0x1954C3FF, 0x77A8FFFF}},
    PaletteRow{&Palette::q, {0xAAB0B9FF, 0x5A5A5AFF, 0xBEBEBDFF}},
    PaletteRow{&Palette::chosen, {0xFFD040FF, 0x583800FF, 0xFFDC40FF}},
    PaletteRow{&Palette::probed, {0x5EE4F4FF, 0x006C80FF, 0x46E6FFFF}},
    PaletteRow{&Palette::changed, {0xC899DDFF, 0x691FA2FF, 0xD391DBFF}},
    PaletteRow{&Palette::problem, {0xFF8B5DFF, 0xAC3F00FF, 0xF88D53FF}},
    PaletteRow{&Palette::text, {0xDEE2E8FF, 0x1C2026FF, 0xFFFFFFFF}},
    PaletteRow{&Palette::dim, {0xA4ABB6FF, 0x545B66FF, 0xD0D0D0FF}},
    PaletteRow{&Palette::faint, {0x848C98FF, 0x666D78FF, 0xB4B4B4FF}},
    PaletteRow{&Palette::keyword, {0x7FB8BAFF, 0x006268FF, 0x8FE3E6FF}},
    PaletteRow{&Palette::uniform, {0xCEBE90FF, 0x745400FF, 0xF0DCA0FF}},
    PaletteRow{&Palette::accent, {0x7696BEFF, 0x2F66A8FF, 0x6FB4FFFF}},
    PaletteRow{&Palette::outline, {0xE1E6F078, 0x1E242E82, 0xFFFFFFA0}},
    PaletteRow{&Palette::blamed, {0xFF8B5D3C, 0xAC3F0028, 0xF88D5346}},
    PaletteRow{&Palette::lit, {0x7696BE64, 0x4A86CC50, 0x6FB4FF5A}},
    PaletteRow{&Palette::shade, {0x0C0E12E1, 0xFFFFFFE1, 0x000000F0}},
    PaletteRow{&Palette::ground, {0x111317FF, 0xFAFAFBFF, 0x000000FF}},
    PaletteRow{&Palette::board, {0x3E4249FF, 0xC4C8CEFF, 0x303030FF}},
    PaletteRow{&Palette::boardLight, {0x545961FF, 0xDCDFE4FF, 0x484848FF}},
    PaletteRow{&Palette::panel, {0x1E2127FF, 0xEEF0F3FF, 0x000000FF}},
    PaletteRow{&Palette::popup, {0x22262DFF, 0xF8F9FAFF, 0x0A0A0AFF}},
    PaletteRow{&Palette::bar, {0x181A1FFF, 0xE2E5EAFF, 0x242424FF}},
    PaletteRow{&Palette::title, {0x2C3139FF, 0xD6DEE9FF, 0x1C1C1CFF}},
    PaletteRow{&Palette::field, {0x31363FFF, 0xFFFFFFFF, 0x1A1A1AFF}},
    PaletteRow{&Palette::fieldHover, {0x383E48FF, 0xE4EBF5FF, 0x1E1E1EFF}},
    PaletteRow{&Palette::fieldActive, {0x39404AFF, 0xDEE6F2FF, 0x1E1E1EFF}},
    PaletteRow{&Palette::header, {0x323944FF, 0xD9E1ECFF, 0x1C1C1CFF}},
    PaletteRow{&Palette::headerHover, {0x38404DFF, 0xD3DCE8FF, 0x1E1E1EFF}},
    PaletteRow{&Palette::headerActive, {0x3E4A5CFF, 0xC3D3E9FF, 0x1F3A5CFF}},
    PaletteRow{&Palette::selection, {0x466084FF, 0xA9C7ECFF, 0x1F4A80FF}},
    PaletteRow{&Palette::border, {0x404650FF, 0x9AA1ACFF, 0x909090FF}},
    PaletteRow{&Palette::separator, {0x343942FF, 0xC9CED6FF, 0x707070FF}},
    PaletteRow{&Palette::grab, {0x6A7384FF, 0x838993FF, 0x8C8C8CFF}},
    PaletteRow{&Palette::curtain, {0x08090C8C, 0x30363F6E, 0x000000AA}},
};
static_assert(paletteRows.size() * sizeof(ImU32) == sizeof(Palette));

constexpr Palette paletteFor(Theme theme) {
    Palette made{};
    for (const PaletteRow& row : paletteRows) {
        const unsigned hex = row.themes[static_cast<std::size_t>(theme)];
        made.*row.color = IM_COL32(hex >> 24U, hex >> 16U & 255U, hex >> 8U & 255U, hex & 255U);
    }
    return made;
}

constexpr std::array palettes{paletteFor(Theme::Dark), paletteFor(Theme::Light),
                              paletteFor(Theme::HighContrast)};

const Palette* inForce = palettes.data(); // global, like Dear ImGui's own style

} // namespace

const Palette& paletteOf(Theme theme) {
    return palettes[static_cast<std::size_t>(theme)];
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
