#include "app/ui/texture_space/texel_marks.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/explaining.h"
#include "app/ui/texture_space/texel_insets.h"
#include "app/ui/widgets/board.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "texplorer/reference/sampling/ellipse.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

using reference::LevelPatch;
using reference::PlacedTap;

/// Like the image around it: over a board, or opaque.
void drawTexelColor(ImDrawList& draw, ImVec2 low, ImVec2 high, glm::vec4 color, bool board) {
    drawCheckered(draw, low, high, board ? color : glm::vec4(glm::vec3(color), 1));
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
    const ImVec2 end(inset.low.x + inset.size().x, inset.low.y + inset.size().y);
    const float pad = em * 0.2F;
    draw.AddRectFilled({inset.low.x - pad, inset.low.y - insetTitleHeight()},
                       {inset.low.x + inset.width + pad, end.y + pad}, faded(color::ground, 0.96F),
                       em * 0.2F);
    draw.AddText({inset.low.x, inset.low.y - em * 1.15F}, color::text, inset.shown.c_str());
    noteDrawn("patch-frame:" + inset.title, inset.frame().low, inset.frame().high);
    noteDrawn("patch title:" + inset.title, {inset.low.x, inset.low.y - insetTitleHeight()},
              {inset.low.x + ImGui::CalcTextSize(inset.shown.c_str()).x, inset.low.y});
    draw.PushClipRect(inset.low, end, true);
    for (int y = 0; y < patch.size.y; ++y) {
        for (int x = 0; x < patch.size.x; ++x) {
            const glm::vec2 texel(patch.low + glm::ivec2(x, y));
            const ImVec2 a = inset.toWindow(texel + glm::vec2(0, 1));
            const ImVec2 b = inset.toWindow(texel + glm::vec2(1, 0));
            const int index = y * patch.size.x + x;
            drawTexelColor(draw, a, b, patch.colors[static_cast<std::size_t>(index)], board);
            if (inset.cell > 6)
                draw.AddRect(a, b, IM_COL32(128, 128, 128, 70));
        }
    }
    // The edge of the level: outside of it, wrapping decides.
    const ImVec2 levelLow = inset.toWindow(glm::vec2(0, patch.extent.y));
    const ImVec2 levelHigh = inset.toWindow(glm::vec2(patch.extent.x, 0));
    draw.AddRect(levelLow, levelHigh, color::text, 0, 0, em * 0.12F);
    for (const PlacedTap& tap : patch.taps) {
        const glm::vec2 at(tap.at);
        const ImVec2 a = inset.toWindow(at + glm::vec2(0, 1));
        const ImVec2 b = inset.toWindow(at + glm::vec2(1, 0));
        draw.AddRect({a.x + 1, a.y + 1}, {b.x - 1, b.y - 1}, color::shade, 0, 0, em * 0.22F);
        draw.AddRect({a.x + 1, a.y + 1}, {b.x - 1, b.y - 1}, color::probed, 0, 0, em * 0.12F);
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
        const ImVec2 a = inset.toWindow(glm::vec2(tap.at) + glm::vec2(0, 1));
        const ImVec2 at(a.x + 2 + em * 0.1F, a.y + inset.cell - room.y - 2 - em * 0.1F);
        draw.AddRectFilled({at.x - 1, at.y}, {at.x + room.x + 1, at.y + room.y}, color::shade);
        draw.AddText(ImGui::GetFont(), size, at, color::probed, text.c_str());
    }
    draw.PopClipRect();
    noteDrawn(fmt::format("patch:level {}", patch.level), inset.low, end);
}

void drawTexel(ImDrawList& draw, const Canvas& canvas, glm::ivec2 at, glm::ivec2 extent, ImU32 tint) {
    const Box box = texelBox(canvas, at, extent);
    const float em = ImGui::GetFontSize();
    draw.AddRect(box.low, box.high, color::shade, 0, 0, em * 0.2F);
    draw.AddRect(box.low, box.high, tint, 0, 0, em * 0.1F);
}

/// A marked corner of the selected texel, so that it is not distinguished only by its colour.
void drawFlag(ImDrawList& draw, const Box& box) {
    const float em = ImGui::GetFontSize();
    const float side = std::min(box.high.x - box.low.x, em * 0.7F);
    if (side < em * 0.2F)
        return;
    draw.AddTriangleFilled(box.low, {box.low.x + side, box.low.y}, {box.low.x, box.low.y + side},
                           color::chosen);
    noteDrawn("texel flag", box.low, {box.low.x + side, box.low.y + side});
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

/// The extent of a level of the bound texture.
std::optional<glm::ivec2> extentOf(const Session& session, int level) {
    const Texture* texture = boundTexture(session);
    const std::shared_ptr<const TextureImage> image =
        texture ? session.document.images.find(*texture) : nullptr;
    if (!image)
        return std::nullopt;
    const auto summary =
        session.services.levels.summary({image, imageSettings(*texture), selectedUnit(session).target});
    if (!summary)
        return std::nullopt;
    const auto found = std::ranges::find(summary->report.levels, level, &LevelReport::number);
    if (found == summary->report.levels.end())
        return std::nullopt;
    // The report includes a border in the level, the indices of texels begin after it.
    const int border = texture->border != 0 ? 2 : 0;
    const bool flat = selectedUnit(session).target == Target::Texture1D;
    return glm::ivec2(found->width - border, flat ? 1 : found->height - border);
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
    const LevelPatch& patch = heaviestPatch(unit);
    const glm::vec2 place = patch.place / glm::vec2(glm::max(patch.extent, 1));
    drawPlace(draw, canvas.toPixel(place));
}

/// The selected texel, and the one under the mouse, which a click selects.
void markCells(const Session& session, ImDrawList& draw, const Texture& texture, const Inset& inset,
               bool clicked) {
    const LevelPatch& patch = *inset.patch;
    const auto frame = [&](glm::ivec2 at, ImU32 tint) {
        draw.AddRect(inset.toWindow(glm::vec2(at) + glm::vec2(0, 1)),
                     inset.toWindow(glm::vec2(at) + glm::vec2(1, 0)), tint, 0, 0,
                     ImGui::GetFontSize() * 0.2F);
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
            frame(at, color::chosen);
            drawFlag(draw, {inset.toWindow(glm::vec2(at) + glm::vec2(0, 1)),
                            inset.toWindow(glm::vec2(at) + glm::vec2(1, 0))});
        }
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!inset.holds(mouse))
        return;
    const glm::ivec2 at =
        patch.low + glm::ivec2(static_cast<int>((mouse.x - inset.low.x) / inset.cell),
                               static_cast<int>((inset.low.y + inset.size().y - mouse.y) / inset.cell));
    frame(at, color::text);
    if (clicked)
        act(session, [chosen = texel(at)](Session& s) { chooseTexel(s, chosen); });
}

/// A click on the image selects its texel, on the level with the greatest share at the probed pixel; on the
/// base level if no pixel is probed.
void chooseInPlane(const Session& session, const Canvas& canvas, const Texture& texture,
                   const reference::UnitExplanation* unit) {
    const int level = unit ? heaviestPatch(*unit).level : texture.baseLevel;
    const std::optional<glm::ivec2> extent = extentOf(session, level);
    if (!extent)
        return;
    const glm::vec2 at = canvas.toCoord(ImGui::GetIO().MousePos) * glm::vec2(*extent);
    act(session, [texel = texelAt(texture, selectedUnit(session).target, level, *extent,
                                  {reference::floorToInt(at.x), reference::floorToInt(at.y)},
                                  0)](Session& s) { chooseTexel(s, texel); });
}

} // namespace

bool isOnPatch(const Session& session, const Canvas& canvas, ImVec2 mouse) {
    return std::ranges::any_of(insetsOf(probedUnit(session), canvas),
                               [mouse](const Inset& inset) { return inset.holds(mouse); });
}

void drawTexelMarks(const Session& session, ImDrawList& draw, const Canvas& canvas, bool clicked,
                    bool board) {
    const Texture* texture = boundTexture(session);
    const reference::UnitExplanation* unit = probedUnit(session);
    if (unit && unit->patches.empty())
        unit = nullptr;
    if (!texture)
        return;
    // The faces of a cube map in this plane are not arranged by their coordinates.
    const bool isCube = selectedUnit(session).target == Target::CubeMap;
    if (clicked && session.look.explaining.isOpen && !isCube &&
        !isOnPatch(session, canvas, ImGui::GetIO().MousePos))
        chooseInPlane(session, canvas, *texture, unit);
    if (unit && !isCube) {
        markPlane(draw, canvas, *unit);
        const Box marks = marksOf(*unit, canvas);
        noteDrawn("texel marks", marks.low, marks.high);
    }
    if (const auto asked = askedTexel(session); asked && !isCube) {
        if (const auto extent = extentOf(session, asked->level)) {
            drawTexel(draw, canvas, glm::ivec2(asked->index), *extent, color::chosen);
            drawFlag(draw, texelBox(canvas, glm::ivec2(asked->index), *extent));
        }
    }
    if (!unit)
        return;
    for (const Inset& inset : insetsOf(unit, canvas)) {
        drawInset(draw, *unit, inset, board);
        markCells(session, draw, *texture, inset, clicked);
    }
}

} // namespace texplorer::ui
