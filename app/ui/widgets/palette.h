#pragma once

#include "app/ui/state/settings.h"

#include <imgui.h>

namespace texplorer::ui {

/// The colours of a theme. Everything is readable on its ground: contrast 4.5:1 for text, 3:1 for marks (WCAG
/// 2.1, 1.4.3 and 1.4.11). The marks, s to problem, can be distinguished by people who see two of the three
/// primaries. tests/ui/widgets/palette_test.cpp computes both.
struct Palette {
    ImU32 s;       ///< texture coordinate s, and x
    ImU32 t;       ///< t, and y
    ImU32 r;       ///< r, and z
    ImU32 q;       ///< q, and w
    ImU32 chosen;  ///< the selected vertex and its face
    ImU32 probed;  ///< the probed pixel and its texels
    ImU32 changed; ///< differs from the initial value; the last change
    ImU32 problem; ///< errors and warnings
    ImU32 text;
    ImU32 dim;
    ImU32 faint;   ///< line numbers
    ImU32 keyword; ///< words of a programming language
    ImU32 uniform; ///< uniforms of a shader
    ImU32 accent;  ///< held, ticked or focused items
    ImU32 outline; ///< faces that are not selected
    ImU32 blamed;  ///< behind a line with an error
    ImU32 lit;     ///< behind related bytes; the bars of a chart

    ImU32 shade;      ///< under a line or a text on a picture
    ImU32 ground;     ///< behind pictures
    ImU32 board;      ///< the dark fields of the board behind transparent parts
    ImU32 boardLight; ///< its light fields
    ImU32 panel;
    ImU32 popup;
    ImU32 bar; ///< behind menus and status
    ImU32 title;
    ImU32 field;
    ImU32 fieldHover;
    ImU32 fieldActive;
    ImU32 header;
    ImU32 headerHover;
    ImU32 headerActive;
    ImU32 selection; ///< behind selected text
    ImU32 border;
    ImU32 separator;
    ImU32 grab;    ///< of scroll bars
    ImU32 curtain; ///< over the window behind a dialog
};

[[nodiscard]] const Palette& paletteOf(Theme theme);

/// The palette set by applyTheme.
[[nodiscard]] const Palette& palette();
void usePalette(Theme theme);

/// A colour of the current theme.
struct ThemeColor {
    ImU32 Palette::*member;

    operator ImU32() const { return palette().*member; } // NOLINT(google-explicit-constructor): it is one
};

// Each kind of thing has the same colour everywhere.
namespace color {
inline constexpr ThemeColor s{&Palette::s};
inline constexpr ThemeColor t{&Palette::t};
inline constexpr ThemeColor r{&Palette::r};
inline constexpr ThemeColor q{&Palette::q};
inline constexpr ThemeColor chosen{&Palette::chosen};
inline constexpr ThemeColor probed{&Palette::probed};
inline constexpr ThemeColor changed{&Palette::changed};
inline constexpr ThemeColor problem{&Palette::problem};
inline constexpr ThemeColor text{&Palette::text};
inline constexpr ThemeColor dim{&Palette::dim};
inline constexpr ThemeColor faint{&Palette::faint};
inline constexpr ThemeColor keyword{&Palette::keyword};
inline constexpr ThemeColor uniform{&Palette::uniform};
inline constexpr ThemeColor accent{&Palette::accent};
inline constexpr ThemeColor outline{&Palette::outline};
inline constexpr ThemeColor blamed{&Palette::blamed};
inline constexpr ThemeColor lit{&Palette::lit};
inline constexpr ThemeColor shade{&Palette::shade};
inline constexpr ThemeColor ground{&Palette::ground};
inline constexpr ThemeColor board{&Palette::board};
inline constexpr ThemeColor boardLight{&Palette::boardLight};
inline constexpr ThemeColor panel{&Palette::panel};
} // namespace color

/// The colour of component 0 to 3: s, t, r, q.
[[nodiscard]] ImU32 componentColor(int component);

} // namespace texplorer::ui
