#include "app/ui/figures/block_microscope.h"
#include "app/ui/figures/block_swatch.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/points.h"

#include <fmt/core.h>

#include <cmath>

namespace texplorer::ui {
namespace {

float axisRoom() {
    return std::floor(ImGui::GetFontSize() * 1.1F);
}

/// s to the right, and t downwards, because the first row of bytes is that at the lowest t.
void drawBlockAxes(ImDrawList& draw, ImVec2 corner, float extent) {
    const float em = ImGui::GetFontSize();
    const float room = axisRoom();
    const float head = em * 0.2F;
    const float thick = std::max(1.0F, em / 10);
    const float middle = room * 0.5F;
    const float from = room + em * 0.9F;
    const float to = room + extent;
    const auto arrow = [&](ImVec2 begin, ImVec2 end, ImVec2 way, ImU32 ink) {
        const ImVec2 side(-way.y, way.x);
        draw.AddLine(corner + begin, corner + end - way, ink, thick);
        draw.AddTriangleFilled(corner + end, corner + end - way * 2 - side, corner + end - way * 2 + side,
                               ink);
    };
    draw.AddText(corner + ImVec2(room, -em * 0.1F), color::s, "s");
    arrow({from, middle}, {to, middle}, {head, 0}, color::s);
    draw.AddText(corner + ImVec2(em * 0.3F, room - em * 0.1F), color::t, "t");
    arrow({middle, from}, {middle, to}, {0, head}, color::t);
}

Sentence texelTip(const BlockMicroscopeState& state, const BlockLook& look, std::size_t texel,
                  const BlockColor& color) {
    return alphaCount(state.format) > 0
               ? Sentence("Texel {0}, {1}: {2} {3} {4}, alpha {5}, colour index {6}, alpha {7}", texel % 4,
                          texel / 4, color[0], color[1], color[2], color[3], look.fields.indices[texel],
                          look.fields.alphas[texel])
               : Sentence("Texel {0}, {1}: {2} {3} {4}, alpha {5}, colour index {6}", texel % 4, texel / 4,
                          color[0], color[1], color[2], color[3], look.fields.indices[texel]);
}

} // namespace

float blockTexelsWidth(float cell) {
    return axisRoom() + 4 * cell;
}

void drawBlockTexels(BlockMicroscopeState& state, const BlockLook& look, float cell) {
    const std::array<BlockColor, 16> texels = texelsOf(state.format, state.block);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    drawBlockAxes(draw, corner, 4 * cell);
    const ImVec2 low = corner + ImVec2(axisRoom(), axisRoom());
    const auto placeOf = [&](std::size_t texel) {
        return low + ImVec2(static_cast<float>(texel % 4), static_cast<float>(texel / 4)) * cell;
    };
    for (std::size_t texel = 0; texel < texels.size(); ++texel) {
        ImGui::SetCursorScreenPos(placeOf(texel));
        const Spot spot = spotHere(fmt::format("texel {}", texel).c_str(), {cell, cell});
        noteItem(fmt::format("block:texel {}", texel));
        drawSwatch(spot.low, spot.high - ImVec2(1, 1), texels[texel]);
        if (cell > ImGui::GetFontSize() * 1.8F)
            drawOnSwatch(spot.low, spot.high, fmt::format("{:02b}", look.fields.indices[texel]).c_str());
        if (spot.hovered) {
            state.hovering = BlockMark{BlockMark::Kind::Texel, texel};
            helpTip(texelTip(state, look, texel, texels[texel]));
        }
        if (!spot.pressed)
            continue;
        if (state.texel == texel)
            writeField(state.block, blockField(state.format, BlockPart::ColorIndex, static_cast<int>(texel)),
                       look.fields.indices[texel] + 1U);
        state.texel = texel;
    }
    for (std::size_t texel = 0; texel < texels.size(); ++texel) { // over the neighbours
        const ImVec2 at = placeOf(texel);
        drawSwatchFrame(at, at + ImVec2(cell - 1, cell - 1), texel == state.texel,
                        look.lit.texels.test(texel));
    }
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({blockTexelsWidth(cell), blockTexelsWidth(cell)});
}

} // namespace texplorer::ui
