#include "app/ui/texture_space/plane_drawing.h"

#include "app/ui/widgets/board.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/tiling.h"

#include <glm/glm.hpp>

namespace texplorer::ui {
namespace {

constexpr int maxTiles = 2048; // keeps the worst case below 65536 vertices
constexpr int tilesAround = 2; // copies of the image beyond the vertices

/// The share of the border in a tile: half of the surroundings with GL_CLAMP and a linear filter, and three
/// quarters if both coordinates leave the image.
float borderShare(const Texture& texture, int i, int j) {
    if (texture.magFilter != MagFilter::Linear)
        return 0;
    const float s = texture.wrapS == Wrap::Clamp && i != 0 ? 0.5F : 1;
    const float t = texture.wrapT == Wrap::Clamp && j != 0 ? 0.5F : 1;
    return 1 - s * t;
}

} // namespace

ImU32 faded(ImU32 tint, float share) {
    ImVec4 color = ImGui::ColorConvertU32ToFloat4(tint);
    color.w *= share;
    return ImGui::ColorConvertFloat4ToU32(color);
}

Box chipBox(ImVec2 at, ImVec2 size) {
    const ImVec2 pad(ImGui::GetFontSize() * 0.2F, 0);
    return {at - pad, at + size + pad};
}

void drawTextChip(ImDrawList& draw, const Box& box, float size, ImU32 tint, const std::string& text) {
    const float pad = ImGui::GetFontSize() * 0.2F;
    draw.AddRectFilled(box.low, box.high, color::shade, pad);
    draw.AddText(ImGui::GetFont(), size, {box.low.x + pad, box.low.y}, tint, text.c_str());
}

Bounds boundsOf(const PlaneCoords& coords) {
    Bounds bounds;
    for (const auto* places : {&coords.givenPlaces(), &coords.resultingPlaces()}) {
        for (const glm::vec2& each : *places)
            if (isPlace(each))
                bounds.include(each);
    }
    return bounds;
}

void drawTiles(ImDrawList& draw, const Canvas& canvas, const Texture& texture, const TilePicture& shown,
               const Bounds& used) {
    const glm::vec2 seenLow = canvas.toCoord({canvas.low.x, canvas.high.y});
    const glm::vec2 seenHigh = canvas.toCoord({canvas.high.x, canvas.low.y});
    const float around = tilesAround;
    const auto tile = [](float coord) {
        return static_cast<int>(std::floor(std::clamp(coord, -1e6F, 1e6F)));
    };
    int left = tile(std::max(seenLow.x, used.low.x - around));
    int right = tile(std::min(seenHigh.x, used.high.x + around));
    int bottom = tile(std::max(seenLow.y, used.low.y - around));
    int top = tile(std::min(seenHigh.y, used.high.y + around));
    const bool many = static_cast<long long>(right - left + 1) * (top - bottom + 1) > maxTiles;
    const auto picture = textureId(shown.handle);
    const ImU32 border = ImGui::ColorConvertFloat4ToU32(
        {texture.borderColor.x, texture.borderColor.y, texture.borderColor.z, texture.borderColor.w});
    const ImU32 opaqueBorder = border | IM_COL32_A_MASK;
    const bool fills = !many && left == tile(seenLow.x) && right == tile(seenHigh.x) &&
                       bottom == tile(seenLow.y) && top == tile(seenHigh.y) &&
                       texture.wrapS != Wrap::ClampToBorder && texture.wrapT != Wrap::ClampToBorder;
    if (many)
        left = right = bottom = top = 0;
    const bool hidesGround = fills && shown.opaque && shown.setBlending;
    if (!hidesGround)
        draw.AddRectFilled(canvas.low, canvas.high, color::ground);
    if (!hidesGround && shown.board)
        drawBoard(draw, canvas.low, canvas.high, ImGui::GetFontSize() * 0.8F);
    const bool blends = !shown.setBlending || !(hidesGround || shown.ignoresAlpha);
    if (!blends)
        draw.AddCallback(shown.setBlending, nullptr);
    struct Shade {
        ImVec2 low, high;
        float share; ///< of the border
    };
    std::vector<Shade> shades; // with blending, after the pictures
    for (int j = bottom; j <= top; ++j) {
        for (int i = left; i <= right; ++i) {
            const auto s = tileSpan(texture.wrapS, i, shown.width);
            const auto t = tileSpan(texture.wrapT, j, shown.height);
            const ImVec2 low = canvas.toPixel(static_cast<float>(i), static_cast<float>(j + 1));
            const ImVec2 high = canvas.toPixel(static_cast<float>(i + 1), static_cast<float>(j));
            if (s && t)
                draw.AddImage(picture, low, high, {s->from, t->to}, {s->to, t->from});
            else
                draw.AddRectFilled(low, high, border);
            if (const float share = borderShare(texture, i, j); s && t && share > 0)
                shades.push_back({low, high, share});
        }
    }
    if (!blends)
        draw.AddCallback(shown.setBlending, &draw);
    for (const Shade& each : shades)
        draw.AddRectFilled(each.low, each.high, faded(opaqueBorder, each.share));
    // The surroundings by wrapping are slightly darker than the image.
    const ImU32 dark = faded(color::ground, 0.41F);
    const ImVec2 low = canvas.toPixel(0, 1);
    const ImVec2 high = canvas.toPixel(1, 0);
    draw.AddRectFilled(canvas.low, {canvas.high.x, low.y}, dark);
    draw.AddRectFilled({canvas.low.x, high.y}, canvas.high, dark);
    draw.AddRectFilled({canvas.low.x, low.y}, {low.x, high.y}, dark);
    draw.AddRectFilled({high.x, low.y}, {canvas.high.x, high.y}, dark);
}

void drawUnfolded(ImDrawList& draw, const Canvas& canvas, view::PictureHandle picture, float tall) {
    const ImVec2 low = canvas.toPixel(0, 0.5F + tall / 2);
    const ImVec2 high = canvas.toPixel(1, 0.5F - tall / 2);
    draw.AddImage(textureId(picture), low, high, {0, 1}, {1, 0});
}

void drawAxes(ImDrawList& draw, const Canvas& canvas) {
    const float em = ImGui::GetFontSize();
    const float beyond = em * 1.6F;
    const float thick = std::max(1.5F, em / 8);
    const ImVec2 origin = canvas.toPixel(0, 0);
    const ImVec2 s(canvas.toPixel(1, 0).x + beyond, origin.y);
    const ImVec2 t(origin.x, canvas.toPixel(0, 1).y - beyond);
    const float head = em * 0.35F;
    for (const ImVec2 end : {s, t})
        draw.AddLine(origin, end, color::shade, thick + 2);
    const auto arrow = [&](ImVec2 end, ImVec2 way, ImVec2 side, ImU32 tint) {
        draw.AddLine(origin, end, tint, thick);
        draw.AddTriangleFilled(end + way * 2, end - side, end + side, tint);
    };
    arrow(s, {head, 0}, {0, head}, color::s);
    arrow(t, {0, -head}, {-head, 0}, color::t);
    const auto label = [&](ImVec2 at, ImU32 tint, const char* text) {
        drawTextChip(draw, chipBox(at, ImGui::CalcTextSize(text)), em, tint, text);
    };
    label({s.x - em * 0.2F, s.y + em * 0.5F}, color::s, "s");
    label({t.x - em * 1.3F, t.y - em * 0.4F}, color::t, "t");
    label({canvas.toPixel(1, 0).x - em * 0.3F, s.y + em * 0.5F}, color::text, "1");
    label({t.x - em * 1.3F, canvas.toPixel(0, 1).y - em * 0.4F}, color::text, "1");
    label({origin.x - em * 1.1F, origin.y + em * 0.5F}, color::text, "0");
}

} // namespace texplorer::ui
