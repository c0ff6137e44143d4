#include "app/ui/model/explaining.h"
#include "app/ui/texture_space/plane_look.h"
#include "app/ui/texture_space/texel_insets.h"
#include "app/ui/widgets/board.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "texplorer/reference/sampling/ellipse.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

using reference::LevelPatch;
using reference::PlacedTap;

/// A rectangle with a shade on both sides of its line.
void drawFrame(ImDrawList& draw, const Box& box, ImU32 tint, float shade, float width) {
    draw.AddRect(box.low, box.high, color::shade, 0, 0, shade);
    draw.AddRect(box.low, box.high, tint, 0, 0, width);
}

void drawFootprint(ImDrawList& draw, const Corners& corners) {
    if (!isFinite(corners))
        return;
    const float em = ImGui::GetFontSize();
    const int count = static_cast<int>(corners.size());
    draw.AddPolyline(corners.data(), count, color::shade, ImDrawFlags_Closed, em * 0.24F);
    draw.AddPolyline(corners.data(), count, color::probed, ImDrawFlags_Closed, em * 0.1F);
}

void drawPlace(ImDrawList& draw, ImVec2 at) {
    const float em = ImGui::GetFontSize();
    draw.AddCircleFilled(at, em * 0.26F, color::shade);
    draw.AddCircleFilled(at, em * 0.18F, color::probed);
}

std::string weightText(float weight) {
    const std::string text = fmt::format("{:.2f}", weight);
    return text.starts_with('0') ? text.substr(1) : text; // ".25"
}

void drawInset(ImDrawList& draw, const reference::UnitExplanation& unit, const Inset& inset, bool board) {
    const LevelPatch& patch = *inset.patch;
    const float em = ImGui::GetFontSize();
    const ImVec2 end = inset.low + inset.size();
    const Box frame = inset.frame();
    draw.AddRectFilled(frame.low, frame.high, faded(color::ground, 0.96F), em * 0.2F);
    draw.AddText({inset.low.x, inset.low.y - em * 1.15F}, color::text, inset.shown.c_str());
    noteDrawn("patch-frame:" + inset.title.english(), frame.low, frame.high);
    noteDrawn(N_("patch title:") + inset.title.english(), {inset.low.x, inset.low.y - insetTitleHeight()},
              {inset.low.x + ImGui::CalcTextSize(inset.shown.c_str()).x, inset.low.y});
    draw.PushClipRect(inset.low, end, true);
    for (int y = 0; y < patch.size.y; ++y) {
        for (int x = 0; x < patch.size.x; ++x) {
            const auto [a, b] = inset.boxOf(patch.low + glm::ivec2(x, y));
            const glm::vec4& color = patch.colors[static_cast<std::size_t>(y * patch.size.x + x)];
            drawCheckered(draw, a, b, board ? color : glm::vec4(glm::vec3(color), 1)); // as in the image
            if (inset.cell > 6)
                draw.AddRect(a, b, IM_COL32(128, 128, 128, 70));
        }
    }
    // The edge of the level: outside of it, wrapping decides.
    draw.AddRect(inset.toWindow(glm::vec2(0, patch.extent.y)), inset.toWindow(glm::vec2(patch.extent.x, 0)),
                 color::text, 0, 0, em * 0.12F);
    for (const PlacedTap& tap : patch.taps) {
        const auto [a, b] = inset.boxOf(tap.at);
        drawFrame(draw, {a + ImVec2(1, 1), b - ImVec2(1, 1)}, color::probed, em * 0.22F, em * 0.12F);
    }
    const glm::vec2 extent(patch.extent);
    const reference::Derivatives& derivatives =
        unit.sample.cube ? unit.sample.cube->derivatives : unit.derivatives;
    const glm::vec2 dx = glm::vec2(derivatives.dx) * extent;
    const glm::vec2 dy = glm::vec2(derivatives.dy) * extent;
    const ImVec2 middle = inset.toWindow(patch.place);
    drawFootprint(draw, footprintOf(middle, {dx.x * inset.cell, -dx.y * inset.cell},
                                    {dy.x * inset.cell, -dy.y * inset.cell}));
    drawPlace(draw, middle);
    for (const PlacedTap& tap : patch.taps) { // over everything else
        const std::string text = weightText(tap.tap.weight);
        const float size = em * 0.85F;
        const ImVec2 room = ImGui::GetFont()->CalcTextSizeA(size, 1000, 0, text.c_str());
        if (room.x + em * 0.5F > inset.cell)
            continue;
        const ImVec2 a = inset.boxOf(tap.at).low;
        const ImVec2 at(a.x + 2 + em * 0.1F, a.y + inset.cell - room.y - 2 - em * 0.1F);
        draw.AddRectFilled(at - ImVec2(1, 0), at + room + ImVec2(1, 0), color::shade);
        draw.AddText(ImGui::GetFont(), size, at, color::probed, text.c_str());
    }
    draw.PopClipRect();
    noteDrawn(fmt::format("patch:level {}", patch.level), inset.low, end);
}

void drawTexel(ImDrawList& draw, const Canvas& canvas, glm::ivec2 at, glm::ivec2 extent, ImU32 tint) {
    const float em = ImGui::GetFontSize();
    drawFrame(draw, texelBox(canvas, at, extent), tint, em * 0.2F, em * 0.1F);
}

/// A marked corner of the selected texel, so that it is not distinguished only by its colour.
void drawFlag(ImDrawList& draw, const Box& box) {
    const float em = ImGui::GetFontSize();
    const float side = std::min(box.high.x - box.low.x, em * 0.7F);
    if (side < em * 0.2F)
        return;
    draw.AddTriangleFilled(box.low, {box.low.x + side, box.low.y}, {box.low.x, box.low.y + side},
                           color::chosen);
    noteDrawn(N_("texel flag"), box.low, {box.low.x + side, box.low.y + side});
}

/// Wraps a texel that is outside of its level. A line has only one row.
reference::TexelPlace texelAt(const Texture& texture, Target target, int level, glm::ivec2 extent,
                              glm::ivec2 at, int layer) {
    const int row = target == Target::Texture1D ? 0 : reference::wrappedTexel(texture.wrapT, at.y, extent.y);
    return {level, {reference::wrappedTexel(texture.wrapS, at.x, extent.x), row, layer}};
}

/// The texel of a cell. Outside of a corner of a seamless cube map there is none: the texel at the corner is
/// used.
reference::TexelPlace texelOf(const Texture& texture, Target target, const LevelPatch& patch, glm::ivec2 at) {
    if (!patch.seamless)
        return texelAt(texture, target, patch.level, patch.extent, at, patch.layer);
    const int size = patch.extent.x;
    const reference::FaceTexel corner{patch.layer, glm::clamp(at, 0, size - 1)};
    const auto [face, index] =
        reference::foldedTexel({patch.layer, glm::clamp(at, -size, 2 * size - 1)}, size).value_or(corner);
    return {patch.level, {index.x, index.y, face}};
}

/// The selected texel, if it belongs to the selected unit.
std::optional<reference::TexelPlace> askedTexel(const Session& session) {
    const std::optional<reference::TexelQuestion>& asked = session.look.explaining.texel;
    if (!asked || asked->pass != session.look.selection.pass || asked->unit != session.look.selection.unit)
        return std::nullopt;
    return asked->texel;
}

/// In the plane of the image: the texels, the footprint and the position of the sample.
void markPlane(ImDrawList& draw, const Canvas& canvas, const reference::UnitExplanation& unit) {
    for (const LevelPatch& patch : unit.patches) {
        for (const PlacedTap& tap : patch.taps)
            drawTexel(draw, canvas, tap.at, patch.extent, color::probed);
    }
    drawFootprint(draw, footprintIn(canvas, unit));
    drawPlace(draw, sampleIn(canvas, unit));
}

/// The selected texel, and the one under the mouse, which a click selects.
void markCells(const Session& session, ImDrawList& draw, const Texture& texture, const Inset& inset,
               bool clicked) {
    const LevelPatch& patch = *inset.patch;
    const auto frame = [&](const Box& box, ImU32 tint) {
        draw.AddRect(box.low, box.high, tint, 0, 0, ImGui::GetFontSize() * 0.2F);
    };
    const auto texel = [&](glm::ivec2 at) {
        return texelOf(texture, selectedUnit(session).target, patch, at);
    };
    const std::optional<reference::TexelPlace> asked = askedTexel(session);
    for (int y = 0; y < patch.size.y; ++y) {
        for (int x = 0; x < patch.size.x; ++x) {
            const glm::ivec2 at = patch.low + glm::ivec2(x, y);
            if (texel(at) != asked)
                continue;
            frame(inset.boxOf(at), color::chosen);
            drawFlag(draw, inset.boxOf(at));
        }
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!inset.holds(mouse))
        return;
    const glm::ivec2 at =
        patch.low + glm::ivec2(static_cast<int>((mouse.x - inset.low.x) / inset.cell),
                               static_cast<int>((inset.low.y + inset.size().y - mouse.y) / inset.cell));
    frame(inset.boxOf(at), color::text);
    if (clicked)
        act(session, [chosen = texel(at)](Session& s) { chooseTexel(s, chosen); });
}

/// A click on the image selects its texel, on the level with the greatest share at the probed pixel; on the
/// base level if no pixel is probed.
void chooseInPlane(const Session& session, const Canvas& canvas, const Texture& texture,
                   const reference::UnitExplanation* unit) {
    const int level = unit ? heaviestPatch(*unit).level : texture.baseLevel;
    const std::optional<glm::ivec3> extent = extentOfBound(session, level);
    if (!extent)
        return;
    const glm::vec2 at = canvas.toCoord(ImGui::GetIO().MousePos) * glm::vec2(*extent);
    act(session, [texel = texelAt(texture, selectedUnit(session).target, level, glm::ivec2(*extent),
                                  {reference::floorToInt(at.x), reference::floorToInt(at.y)},
                                  0)](Session& s) { chooseTexel(s, texel); });
}

} // namespace

void drawTexelMarks(const Session& session, ImDrawList& draw, const Canvas& canvas,
                    std::span<const Inset> insets, bool clicked, bool board) {
    const Texture* texture = boundTexture(session);
    const reference::UnitExplanation* unit = probedUnit(session);
    if (unit && unit->patches.empty())
        unit = nullptr;
    if (!texture)
        return;
    // The faces of a cube map in this plane are not arranged by their coordinates.
    const bool isCube = selectedUnit(session).target == Target::CubeMap;
    const auto isUnder = [](const Inset& inset) { return inset.holds(ImGui::GetIO().MousePos); };
    if (clicked && session.look.explaining.isOpen && !isCube && std::ranges::none_of(insets, isUnder))
        chooseInPlane(session, canvas, *texture, unit);
    if (unit && !isCube) {
        markPlane(draw, canvas, *unit);
        const Box marks = marksOf(*unit, canvas);
        noteDrawn(N_("texel marks"), marks.low, marks.high);
    }
    if (const auto asked = askedTexel(session); asked && !isCube) {
        if (const auto extent = extentOfBound(session, asked->level)) {
            drawTexel(draw, canvas, glm::ivec2(asked->index), glm::ivec2(*extent), color::chosen);
            drawFlag(draw, texelBox(canvas, glm::ivec2(asked->index), glm::ivec2(*extent)));
        }
    }
    for (const Inset& inset : insets) {
        drawInset(draw, *unit, inset, board);
        markCells(session, draw, *texture, inset, clicked);
    }
}

} // namespace texplorer::ui
