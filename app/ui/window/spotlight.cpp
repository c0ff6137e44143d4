#include "app/ui/window/window_parts.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <numbers>

namespace texplorer::ui {
namespace {

constexpr float discRadius = 7;  ///< in letters' heights
constexpr float softEdge = 0.8F; ///< in letters' heights: the width from light to dim
constexpr int discCorners = 96;
constexpr ImU32 lightInside = IM_COL32(0, 0, 0, 0);
constexpr ImU32 dimOutside = IM_COL32(0, 0, 0, 165);

} // namespace

/// Three rings of corners: where it is light, where it is dim, and outside of the window. Triangles connect
/// them.
void drawSpotlight(const Session& session, const Layout& layout) {
    if (!session.window.spotlight || !ImGui::IsMousePosValid())
        return;
    const ImVec2 centre = ImGui::GetIO().MousePos;
    const float em = ImGui::GetFontSize();
    const float beyond =
        2 * std::hypot(static_cast<float>(layout.window.width), static_cast<float>(layout.window.height));
    struct Ring {
        float radius;
        ImU32 tint;
    };
    const std::array rings{Ring{discRadius * em, lightInside}, Ring{(discRadius + softEdge) * em, dimOutside},
                           Ring{beyond, dimOutside}};
    constexpr auto count = static_cast<int>(rings.size());
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    draw.PrimReserve(discCorners * (count - 1) * 6, discCorners * count);
    const unsigned first = draw._VtxCurrentIdx;
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    for (int corner = 0; corner < discCorners; ++corner) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(corner) / discCorners;
        for (const Ring& ring : rings)
            draw.PrimWriteVtx(
                {centre.x + ring.radius * std::cos(angle), centre.y + ring.radius * std::sin(angle)}, white,
                ring.tint);
    }
    const auto at = [&](int corner, int ring) {
        return static_cast<ImDrawIdx>(first + static_cast<unsigned>(corner % discCorners * count + ring));
    };
    for (int corner = 0; corner < discCorners; ++corner) {
        for (int ring = 0; ring + 1 < count; ++ring) {
            for (const ImDrawIdx index : {at(corner, ring), at(corner + 1, ring), at(corner + 1, ring + 1),
                                          at(corner, ring), at(corner + 1, ring + 1), at(corner, ring + 1)})
                draw.PrimWriteIdx(index);
        }
    }
}

} // namespace texplorer::ui
