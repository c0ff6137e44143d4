#pragma once

#include <imgui.h>

namespace texplorer::ui {

// One thing has one colour everywhere.
namespace color {
inline constexpr ImU32 s = IM_COL32(235, 111, 111, 255);     ///< texture coordinate s, and x
inline constexpr ImU32 t = IM_COL32(126, 200, 116, 255);     ///< t, and y
inline constexpr ImU32 r = IM_COL32(102, 163, 245, 255);     ///< r, and z
inline constexpr ImU32 q = IM_COL32(160, 166, 176, 255);     ///< q, and w
inline constexpr ImU32 chosen = IM_COL32(255, 208, 64, 255); ///< the chosen vertex and its face
inline constexpr ImU32 probed = IM_COL32(70, 214, 232, 255); ///< the probed pixel and its texels
inline constexpr ImU32 changed =
    IM_COL32(190, 150, 255, 255); ///< differs from the initial value; what changed last
inline constexpr ImU32 problem = IM_COL32(255, 138, 92, 255); ///< errors and warnings
inline constexpr ImU32 text = IM_COL32(222, 226, 232, 255);
inline constexpr ImU32 dim = IM_COL32(142, 150, 162, 255);
inline constexpr ImU32 faint = IM_COL32(98, 106, 118, 255);    ///< line numbers
inline constexpr ImU32 keyword = IM_COL32(127, 184, 186, 255); ///< words of a programming language
inline constexpr ImU32 uniform = IM_COL32(206, 190, 144, 255); ///< what a shader is given from outside
inline constexpr ImU32 blamed = IM_COL32(255, 138, 92, 60);    ///< behind a line with a mistake
inline constexpr ImU32 outline = IM_COL32(225, 230, 240, 120); ///< faces that are not the chosen one
inline constexpr ImU32 shade = IM_COL32(12, 14, 18, 200);      ///< under a line or a text on a picture
inline constexpr ImU32 ground = IM_COL32(17, 19, 23, 255);     ///< behind pictures
} // namespace color

/// The colour of component 0 to 3: s, t, r, q.
[[nodiscard]] ImU32 componentColor(int component);

/// Sets the current ImGui context up: fonts, colours and metrics for a content scale, no imgui.ini. Call it
/// once before the first frame, and between two frames when the scale changes; the host then renews its font
/// texture.
void applyTheme(float scale);

/// The fixed-width font of applyTheme, for what is code.
[[nodiscard]] ImFont* codeFont();

} // namespace texplorer::ui
