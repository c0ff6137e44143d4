#pragma once

#include "app/ui/model/settings.h"

#include <imgui.h>

namespace texplorer::ui {

/// The colours of a theme. Whatever stands on a ground here can be read there: 4.5:1 for text, 3:1 for marks
/// (WCAG 2.1, 1.4.3 and 1.4.11); and the marks, s to problem, can be told apart by people who see two of the
/// three primaries. tests/ui/widgets/palette_test.cpp computes both.
struct Palette {
    ImU32 s;       ///< texture coordinate s, and x
    ImU32 t;       ///< t, and y
    ImU32 r;       ///< r, and z
    ImU32 q;       ///< q, and w
    ImU32 chosen;  ///< the chosen vertex and its face
    ImU32 probed;  ///< the probed pixel and its texels
    ImU32 changed; ///< differs from the initial value; what changed last
    ImU32 problem; ///< errors and warnings
    ImU32 text;
    ImU32 dim;
    ImU32 faint;   ///< line numbers
    ImU32 keyword; ///< words of a programming language
    ImU32 uniform; ///< what a shader is given from outside
    ImU32 accent;  ///< what is held, ticked or has the keyboard
    ImU32 outline; ///< faces that are not the chosen one
    ImU32 blamed;  ///< behind a line with a mistake
    ImU32 lit;     ///< behind bytes that belong together, and the bars of a chart

    ImU32 shade;      ///< under a line or a text on a picture
    ImU32 ground;     ///< behind pictures
    ImU32 board;      ///< the fields of the board behind what is transparent
    ImU32 boardLight; ///< the others
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

/// That of applyTheme.
[[nodiscard]] const Palette& palette();
void usePalette(Theme theme);

/// A colour of whichever theme is in force.
struct ThemeColor {
    ImU32 Palette::*member;

    operator ImU32() const { return palette().*member; } // NOLINT(google-explicit-constructor): it is one
};

// One thing has one colour everywhere.
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
