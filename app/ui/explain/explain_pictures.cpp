#include "app/ui/explain/explain_cards.h"
#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/widgets/board.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/palette.h"
#include "texplorer/base/translatable.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>

namespace texplorer::ui {
namespace {

using reference::FragmentExplanation;
using reference::UnitExplanation;

/// The rectangle of a picture and its draw list.
struct Sketch {
    ImDrawList& draw;
    ImVec2 low, high;

    [[nodiscard]] float width() const { return high.x - low.x; }
    [[nodiscard]] float height() const { return high.y - low.y; }
    [[nodiscard]] ImVec2 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }

    /// The largest square that fits, in the middle.
    [[nodiscard]] Sketch square() const {
        const float half = std::min(width(), height()) / 2;
        const ImVec2 at = middle();
        return {draw, {at.x - half, at.y - half}, {at.x + half, at.y + half}};
    }
    /// A position in fractions of the size, from the lower left.
    [[nodiscard]] ImVec2 at(float x, float y) const { return {low.x + x * width(), high.y - y * height()}; }
    /// The i-th of `count` parts, from left to right.
    [[nodiscard]] Sketch part(int i, int count) const {
        const float one = width() / static_cast<float>(count);
        const float left = low.x + one * static_cast<float>(i);
        return {draw, {left, low.y}, {left + one, high.y}};
    }
};

void filledBox(const Sketch& box, glm::vec3 color) {
    box.draw.AddRectFilled(box.low, box.high, plotColor(color));
    box.draw.AddRect(box.low, box.high, color::outline);
}

/// A small text centred at a position.
void sketchText(ImDrawList& draw, ImVec2 middle, const std::string& text, ImU32 tint) {
    const float size = ImGui::GetFontSize() * 0.8F;
    const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, text.c_str());
    draw.AddText(ImGui::GetFont(), size,
                 {std::round(middle.x - extent.x / 2), std::round(middle.y - extent.y / 2)}, tint,
                 text.c_str());
}

void sketchDot(const Sketch& box, ImVec2 at) {
    const float radius = ImGui::GetFontSize() * 0.22F;
    box.draw.AddCircleFilled(at, radius + plotLine(), color::ground);
    box.draw.AddCircleFilled(at, radius, color::probed);
}

/// Colours in a row with their names below, and a sign before each but the first.
struct NamedColor {
    const char* sign;
    const char* name;
    glm::vec3 color;
};
void drawNamedColors(const Sketch& box, const std::vector<NamedColor>& colors) {
    const float line = ImGui::GetFontSize() * 0.9F;
    const auto count = static_cast<int>(colors.size());
    const float gap = ImGui::GetFontSize() * 0.75F;
    const float side = std::max(
        1.0F, std::min((box.width() - gap * static_cast<float>(count - 1)) / static_cast<float>(count),
                       box.height() - line));
    const float all = side * static_cast<float>(count) + gap * static_cast<float>(count - 1);
    float x = box.middle().x - all / 2;
    const float top = box.middle().y - (side + line) / 2;
    for (const NamedColor& each : colors) {
        if (each.sign)
            sketchText(box.draw, {x - gap / 2, top + side / 2}, each.sign, color::dim);
        filledBox({box.draw, {x, top}, {x + side, top + side}}, each.color);
        constexpr float small = 0.8F; // see sketchText
        sketchText(box.draw, {x + side / 2, top + side + line / 2}, fitted(each.name, (side + gap) / small),
                   color::dim);
        x += side + gap;
    }
}

/// The corners, the pixel between them, and the weight of each.
void drawVerticesSketch(const Sketch& whole, const FragmentExplanation& fragment) {
    const float em = ImGui::GetFontSize();
    const Sketch box{whole.draw,
                     {whole.low.x + em * 0.5F, whole.low.y + em * 0.4F},
                     {whole.high.x - em * 0.5F, whole.high.y - em * 0.4F}};
    constexpr std::array places{glm::vec2(0, 0), glm::vec2(1, 0.15F), glm::vec2(0.4F, 1)};
    const std::size_t count = std::min(fragment.vertices.size(), places.size());
    const float half = std::min(box.width(), box.height() * 1.3F) / 2;
    const Sketch shape{box.draw, {box.middle().x - half, box.low.y}, {box.middle().x + half, box.high.y}};
    glm::vec2 pixel(0);
    for (std::size_t i = 0; i < count; ++i)
        pixel += places.at(i) * fragment.vertices[i].weight;
    const auto at = [&](glm::vec2 place) { return shape.at(place.x, place.y); };
    const ImVec2 here = at(count == 1 ? places[0] : glm::clamp(pixel, -0.1F, 1.1F));
    for (std::size_t i = 0; i < count; ++i) {
        whole.draw.AddLine(at(places.at(i)), at(places.at((i + 1) % count)), color::outline, plotLine());
        const float weight = std::clamp(fragment.vertices[i].weight, 0.0F, 1.0F);
        whole.draw.AddLine(here, at(places.at(i)), color::probed, plotLine() + em * 0.3F * weight);
    }
    for (std::size_t i = 0; i < count; ++i) {
        whole.draw.AddCircleFilled(at(places.at(i)), em * 0.28F, plotColor(fragment.vertices[i].primary));
        whole.draw.AddCircle(at(places.at(i)), em * 0.28F, color::outline);
    }
    sketchDot(whole, here);
}

/// The unit square and the coordinates inside or outside of it.
void drawCoordinatesSketch(const Sketch& whole, const UnitExplanation& unit) {
    const Sketch box = whole.square();
    glm::vec2 place(unit.coords);
    if (unit.sample.cube)
        place = glm::vec2(unit.sample.cube->coords);
    if (coordinatesOf(unit.target) == 1)
        place.y = 0;
    constexpr float farthest = 2.4F;
    const auto within = [](float coord) {
        return std::isfinite(coord) ? std::clamp(coord, -farthest, 1 + farthest) : 0.0F;
    };
    const glm::vec2 shown(within(place.x), within(place.y));
    const float margin = 0.15F;
    const float low = std::min({0.0F, shown.x, shown.y}) - margin;
    const float high = std::max({1.0F, shown.x, shown.y}) + margin;
    const auto at = [&](float s, float t) {
        return box.at((s - low) / (high - low), (t - low) / (high - low));
    };
    const float line = plotLine();
    whole.draw.AddRectFilled(at(0, 1), at(1, 0), ImGui::GetColorU32(ImGuiCol_FrameBgActive));
    whole.draw.AddRect(at(0, 1), at(1, 0), color::outline);
    whole.draw.AddLine(at(0, 0), at(1, 0), color::s, 2 * line);
    whole.draw.AddLine(at(0, 0), at(0, 1), color::t, 2 * line);
    whole.draw.AddLine(at(shown.x, 0), at(shown.x, shown.y), color::s, line);
    whole.draw.AddLine(at(0, shown.y), at(shown.x, shown.y), color::t, line);
    sketchDot(whole, at(shown.x, shown.y));
    // Large squares have text, so that they are not distinguished only by colour.
    const float em = ImGui::GetFontSize();
    if (box.width() < em * 3)
        return;
    const ImVec2 corner = at(1, 1);
    const ImVec2 origin = at(0, 0);
    sketchText(whole.draw, {corner.x - em * 0.3F, origin.y - em * 0.45F}, "s", color::s);
    sketchText(whole.draw, {origin.x + em * 0.35F, corner.y + em * 0.4F}, "t", color::t);
}

/// The extent of the base level, computed from a level that was read.
glm::vec2 baseExtent(const UnitExplanation& unit) {
    if (unit.extents.empty())
        return glm::vec2(1);
    const reference::LevelExtent& read = unit.extents.front();
    const float factor = std::exp2(static_cast<float>(read.level - unit.sampler.baseLevel));
    const auto along = [&](int size) { return static_cast<float>(size) * factor; };
    return {along(read.size.x), along(read.size.y)};
}

/// The footprint of the pixel over the texels of the base level; below it lambda between the levels.
void drawLodSketch(const Sketch& whole, const UnitExplanation& unit) {
    const float em = ImGui::GetFontSize();
    const Sketch box{whole.draw, whole.low, {whole.high.x, whole.high.y - em * 0.9F}};
    const Sketch grid = box.square();
    const reference::Derivatives& change =
        unit.sample.cube ? unit.sample.cube->derivatives : unit.derivatives;
    const glm::vec2 extent = baseExtent(unit);
    glm::vec2 dx = glm::vec2(change.dx) * extent;
    glm::vec2 dy = glm::vec2(change.dy) * extent;
    const float line = plotLine();
    float reach = std::max({std::abs(dx.x) + std::abs(dy.x), std::abs(dx.y) + std::abs(dy.y)});
    if (!std::isfinite(reach)) {
        reach = 1;
        dx = dy = {};
    }
    // Single texels if there are few, else blocks of 2, 4, 8 …
    const float side = std::max(2.0F, reach * 1.25F);
    const float block = std::exp2(std::max(0.0F, std::ceil(std::log2(side / 6))));
    for (float step = 0; step <= side / 2; step += block) {
        for (const float way : {-step, step}) {
            const float share = 0.5F + way / side;
            whole.draw.AddLine(grid.at(share, 0), grid.at(share, 1), color::faint, line / 2);
            whole.draw.AddLine(grid.at(0, share), grid.at(1, share), color::faint, line / 2);
        }
    }
    const auto corner = [&](float x, float y) {
        const glm::vec2 way = (dx * x + dy * y) / side;
        return grid.at(0.5F + way.x, 0.5F + way.y);
    };
    const std::array corners{corner(-0.5F, -0.5F), corner(0.5F, -0.5F), corner(0.5F, 0.5F),
                             corner(-0.5F, 0.5F)};
    const ImU32 tint = color::probed;
    whole.draw.AddQuadFilled(corners[0], corners[1], corners[2], corners[3],
                             (tint & ~IM_COL32_A_MASK) | (ImU32{70} << IM_COL32_A_SHIFT));
    whole.draw.AddQuad(corners[0], corners[1], corners[2], corners[3], tint, 1.5F * line);

    const float longest = std::max(extent.x, extent.y);
    const int last = std::clamp(static_cast<int>(std::log2(std::max(1.0F, longest))), 1, 14);
    const float y = whole.high.y - em * 0.2F;
    const auto level = [&](float lambda) {
        const float share = std::clamp(lambda / static_cast<float>(last), 0.0F, 1.0F);
        return whole.low.x + em * 0.2F + (whole.width() - em * 0.4F) * share;
    };
    whole.draw.AddLine({level(0), y}, {level(static_cast<float>(last)), y}, color::dim, line);
    for (int i = 0; i <= last; ++i)
        whole.draw.AddLine({level(static_cast<float>(i)), y - em * 0.2F}, {level(static_cast<float>(i)), y},
                           color::dim, line);
    const float lambda = std::isfinite(unit.sample.lod.lambda) ? unit.sample.lod.lambda : 0;
    whole.draw.AddTriangleFilled({level(lambda), y - em * 0.05F},
                                 {level(lambda) - em * 0.25F, y - em * 0.55F},
                                 {level(lambda) + em * 0.25F, y - em * 0.55F}, color::probed);
}

/// The texels around the sample; those that were read have an outline by their weight.
void drawPatchSketch(const Sketch& whole, const reference::LevelPatch& patch) {
    if (patch.size.x < 1 || patch.size.y < 1 || patch.taps.empty())
        return;
    glm::ivec2 low = patch.taps.front().at;
    glm::ivec2 high = low;
    for (const reference::PlacedTap& tap : patch.taps) {
        low = glm::min(low, tap.at);
        high = glm::max(high, tap.at);
    }
    low = glm::max(low - 1, patch.low);
    high = glm::min(high + 1, patch.low + patch.size - 1);
    const glm::ivec2 size = glm::max(high - low + 1, glm::ivec2(1));
    const float cell = std::floor(std::max(1.0F, std::min(whole.width() / static_cast<float>(size.x),
                                                          whole.height() / static_cast<float>(size.y))));
    const ImVec2 middle = whole.middle();
    const ImVec2 origin(std::round(middle.x - cell * static_cast<float>(size.x) / 2),
                        std::round(middle.y + cell * static_cast<float>(size.y) / 2));
    const auto corner = [&](glm::vec2 texel) {
        return ImVec2(origin.x + (texel.x - static_cast<float>(low.x)) * cell,
                      origin.y - (texel.y - static_cast<float>(low.y)) * cell);
    };
    const auto box = [&](glm::ivec2 texel) {
        const ImVec2 lowerLeft = corner(texel);
        return Sketch{whole.draw, {lowerLeft.x, lowerLeft.y - cell}, {lowerLeft.x + cell, lowerLeft.y}};
    };
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            const auto index = static_cast<std::size_t>((y - patch.low.y) * patch.size.x + (x - patch.low.x));
            if (index >= patch.colors.size())
                continue;
            const Sketch each = box({x, y});
            drawCheckered(whole.draw, each.low, each.high, patch.colors[index]);
        }
    }
    for (const reference::PlacedTap& tap : patch.taps) {
        const Sketch each = box(tap.at);
        const float width = std::clamp(tap.tap.weight, 0.0F, 1.0F) * 3 * plotLine() + 1;
        whole.draw.AddRect(each.low, each.high, color::shade, 0, 0, width + 1.5F);
        whole.draw.AddRect(each.low, each.high, color::probed, 0, 0, width);
    }
    if (const glm::vec2 place = glm::clamp(patch.place, glm::vec2(low), glm::vec2(high + 1)); place == place)
        sketchDot(whole, corner(place));
}

void drawTexelsSketch(const Sketch& whole, const UnitExplanation& unit) {
    const int count = std::clamp(static_cast<int>(unit.patches.size()), 1, 2);
    const float gap = ImGui::GetFontSize() * 0.2F;
    for (int i = 0; i < count && i < static_cast<int>(unit.patches.size()); ++i) {
        Sketch part = whole.part(i, count);
        part.low.x += i > 0 ? gap : 0;
        part.high.x -= i + 1 < count ? gap : 0;
        drawPatchSketch(part, unit.patches[static_cast<std::size_t>(i)]);
    }
}

/// The mixture: bars with the heights of the weights, and the resulting colour.
void drawFilterSketch(const Sketch& whole, const UnitExplanation& unit) {
    struct Bar {
        float weight = 0;
        glm::vec4 color{0};
    };
    std::vector<Bar> bars;
    if (unit.sample.levels.size() > 1) {
        std::map<int, Bar> levels;
        for (const reference::Tap& tap : unit.sample.taps) {
            levels[tap.level].weight += tap.weight;
            levels[tap.level].color += tap.color * tap.weight;
        }
        for (const auto& [level, bar] : levels)
            bars.push_back({bar.weight, bar.weight > 0 ? bar.color / bar.weight : bar.color});
    } else {
        for (const reference::Tap& tap : unit.sample.taps)
            bars.push_back({tap.weight, tap.color});
    }
    const float arrow = ImGui::GetFontSize();
    const float side = std::max(1.0F, (whole.width() - arrow) / 2);
    const float half = std::min(side, whole.height()) / 2;
    const ImVec2 middle = whole.middle();
    const float left = middle.x - arrow / 2 - 2 * half;
    const float top = middle.y - half;
    float y = top;
    for (const Bar& bar : bars) {
        const float next = y + 2 * half * std::clamp(bar.weight, 0.0F, 1.0F);
        whole.draw.AddRectFilled({left, y}, {left + 2 * half, next}, plotColor(bar.color));
        y = next;
    }
    whole.draw.AddRect({left, top}, {left + 2 * half, top + 2 * half}, color::outline);
    sketchText(whole.draw, middle, "→", color::dim);
    const float right = middle.x + arrow / 2;
    filledBox({whole.draw, {right, top}, {right + 2 * half, top + 2 * half}}, unit.sample.color);
}

void drawEnvironmentSketch(const Sketch& whole, const UnitExplanation& unit) {
    const std::string written = unit.equations.color.symbols + unit.equations.alpha.symbols;
    const auto names = [&](const char* symbol) { return written.find(symbol) != std::string::npos; };
    std::vector<NamedColor> colors{{nullptr, N_("Cp"), unit.inputs.previous},
                                   {"·", N_("Cs"), unit.inputs.source}};
    if (names(N_("Cc")) || names(N_("Ac")))
        colors.push_back({"·", N_("Cc"), unit.inputs.constant});
    colors.push_back({"→", N_("Cv"), unit.result});
    drawNamedColors(whole, colors);
}

/// Why a unit does nothing, in the place of a picture.
void drawReason(const Sketch& whole, const reference::FragmentExplanation& fragment, int unit) {
    const auto idle = std::ranges::find(fragment.idle, unit, &reference::IdleUnit::unit);
    if (idle == fragment.idle.end())
        return;
    const std::string text = tr(shownSentence(idle->reason));
    const ImVec4 room(whole.low.x, whole.low.y, whole.high.x, whole.high.y);
    whole.draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), whole.low, color::text, text.c_str(), nullptr,
                       room.z - room.x, &room);
}

} // namespace

void drawStagePicture(ImDrawList& draw, ImVec2 low, ImVec2 high, const Card& card,
                      const reference::FragmentExplanation& fragment) {
    if (high.x - low.x < 2 || high.y - low.y < 2)
        return;
    const Sketch whole{draw, low, high};
    const auto found = std::ranges::find(fragment.units, card.unit, &UnitExplanation::unit);
    const UnitExplanation* unit = found == fragment.units.end() ? nullptr : &*found;
    switch (card.stage) {
    case Stage::Vertices:
        return drawVerticesSketch(whole, fragment);
    case Stage::Coordinates:
        return drawCoordinatesSketch(whole, *unit);
    case Stage::LevelOfDetail:
        return drawLodSketch(whole, *unit);
    case Stage::Texels:
        return drawTexelsSketch(whole, *unit);
    case Stage::Filter:
        return drawFilterSketch(whole, *unit);
    case Stage::Environment:
        return drawEnvironmentSketch(whole, *unit);
    case Stage::IdleUnit:
        return drawReason(whole, fragment, card.unit);
    case Stage::ColorSum:
        return drawNamedColors(whole, {{nullptr, "C", fragment.textured},
                                       {"+", N_("spec."), glm::vec4(glm::vec3(fragment.secondary), 1)},
                                       {"→", N_("sum"), fragment.summed}});
    case Stage::Fog:
        return drawNamedColors(whole, {{nullptr, N_("Cr"), fragment.summed},
                                       {"·", N_("Cf"), glm::vec4(glm::vec3(fragment.fog->state.color), 1)},
                                       {"→", "C", fragment.color}});
    case Stage::Tests: {
        const bool drawn = fragment.outcome == reference::FragmentOutcome::Drawn;
        return drawNamedColors(whole,
                               {{nullptr, N_("here"), colorOfBytes(fragment.before)},
                                {"+", N_("new"), fragment.color},
                                {"→", N_("then"), colorOfBytes(drawn ? fragment.after : fragment.before)}});
    }
    case Stage::Pixel:
        filledBox(whole.square(), colorOfBytes(fragment.after));
        break;
    }
}

} // namespace texplorer::ui
