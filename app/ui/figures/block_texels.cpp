#include "app/ui/figures/block_columns.h"
#include "app/ui/figures/block_swatch.h"
#include "app/ui/widgets/param_widgets.h"

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
    const float y = corner.y + room * 0.5F;
    const float x = corner.x + room * 0.5F;
    const float from = room + em * 0.9F;
    const float to = room + extent;
    draw.AddText({corner.x + room, corner.y - em * 0.1F}, color::s, "s");
    draw.AddLine({corner.x + from, y}, {corner.x + to - head, y}, color::s, thick);
    draw.AddTriangleFilled({corner.x + to, y}, {corner.x + to - 2 * head, y - head},
                           {corner.x + to - 2 * head, y + head}, color::s);
    draw.AddText({corner.x + em * 0.3F, corner.y + room - em * 0.1F}, color::t, "t");
    draw.AddLine({x, corner.y + from}, {x, corner.y + to - head}, color::t, thick);
    draw.AddTriangleFilled({x, corner.y + to}, {x + head, corner.y + to - 2 * head},
                           {x - head, corner.y + to - 2 * head}, color::t);
}

std::string texelTip(const BlockMicroscopeState& state, const BlockLook& look, std::size_t texel,
                     const BlockColor& color) {
    const std::string what =
        alphaCount(state.format) > 0
            ? fmt::format("Texel {}, {}: {} {} {}, alpha {}, colour index {}, alpha {}", texel % 4, texel / 4,
                          color[0], color[1], color[2], color[3], look.fields.indices[texel],
                          look.fields.alphas[texel])
            : fmt::format("Texel {}, {}: {} {} {}, alpha {}, colour index {}", texel % 4, texel / 4, color[0],
                          color[1], color[2], color[3], look.fields.indices[texel]);
    return what;
}

} // namespace

float blockTexelsWidth(float cell) {
    return axisRoom() + 4 * cell;
}

float blockTexelsHeight(float cell) {
    return axisRoom() + 4 * cell;
}

void drawBlockTexels(BlockMicroscopeState& state, const BlockLook& look, float cell) {
    const std::array<BlockColor, 16> texels = texelsOf(state.format, state.block);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    drawBlockAxes(draw, corner, 4 * cell);
    const ImVec2 low(corner.x + axisRoom(), corner.y + axisRoom());
    const auto placeOf = [&](std::size_t texel) {
        return ImVec2(low.x + cell * static_cast<float>(texel % 4),
                      low.y + cell * static_cast<float>(texel / 4));
    };
    for (std::size_t texel = 0; texel < texels.size(); ++texel) {
        ImGui::SetCursorScreenPos(placeOf(texel));
        const Spot spot = spotHere(fmt::format("texel {}", texel).c_str(), {cell, cell});
        noteItem(fmt::format("block:texel {}", texel));
        drawSwatch(draw, spot.low, {spot.high.x - 1, spot.high.y - 1}, texels[texel]);
        if (cell > ImGui::GetFontSize() * 1.8F)
            drawOnSwatch(draw, spot.low, spot.high,
                         fmt::format("{:02b}", look.fields.indices[texel]).c_str());
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
        drawSwatchFrame(draw, at, {at.x + cell - 1, at.y + cell - 1},
                        texel == state.texel          ? SwatchFrame::Chosen
                        : look.lit.texels.test(texel) ? SwatchFrame::Lit
                                                      : SwatchFrame::None);
    }
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({blockTexelsWidth(cell), blockTexelsHeight(cell)});
}

} // namespace texplorer::ui
