#include "app/ui/figures/emboss_theory.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_place.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/reference/shading/lighting.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float steepest = 85; // degrees: the light stays above the surface
constexpr Range angleRange{-steepest, steepest, 1, "deg"};
constexpr Range placeRange{0, 1, 0.002F, {}};
constexpr int brickRow = 48; // through the middle of a course

const HeightProfile& profileOf(EmbossTheoryState& state) {
    if (!state.profile || state.drawn != state.line) {
        state.profile = state.line == EmbossTheoryState::Line::Sketch
                            ? sketchedProfile()
                            : texplorer::profileOf(drawPattern(Pattern::BrickHeight),
                                                   drawPattern(Pattern::Brick), brickRow);
        state.drawn = state.line;
    }
    return *state.profile;
}

/// The depth of the scene's first embossing unit.
std::optional<ParamPlace> embossDepth(const Session& session) {
    const Scene& scene = presentScene(session);
    for (std::size_t pass = 0; pass < scene.passes.size(); ++pass) {
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            const Unit& each = scene.passes[pass].units.at(unit);
            if (scene.passes[pass].enabled && each.enabled && each.emboss.enabled)
                return placeOf(scene, fmt::format("{}.{}.{}", elementOf<&Scene::passes>(pass),
                                                  elementOf<&Pass::units>(unit),
                                                  pathOf<&Unit::emboss, &Emboss::depth>()));
        }
    }
    return std::nullopt;
}

/// The brightness of a white surface that faces the viewer, with the scene's light and material.
float brightnessOf(const Scene& scene, float angle) {
    Light light = scene.light;
    light.position = {std::sin(angle), 0, std::cos(angle), 0};
    light.specular = glm::vec4(0);
    const reference::Reflectance surface(scene.material, scene.material.color);
    const reference::LightingTerms terms =
        reference::lightingTerms(light, surface, glm::vec3(0, 0, -1), glm::vec3(0, 0, 1));
    return reference::litColors(terms, surface, ColorControl::Single).primary.r;
}

/// The data of the drawing.
struct EmbossFigure {
    const HeightProfile& profile;
    float light; ///< radians
    float depth;
    float brightness;

    [[nodiscard]] EmbossedPoint at(float s) const { return embossAt(profile, s, light, depth, brightness); }
};

constexpr int embossColumns = 240;

float columnS(int column) {
    return (static_cast<float>(column) + 0.5F) / embossColumns;
}

/// A curve of one number for each position.
template<class Number>
void drawEmbossCurve(ImDrawList& draw, const PlotBox& box, ImU32 ink, float width, const Number& number) {
    std::vector<ImVec2> points;
    points.reserve(embossColumns);
    for (int i = 0; i < embossColumns; ++i)
        points.push_back(box.at(columnS(i), number(columnS(i))));
    draw.AddPolyline(points.data(), static_cast<int>(points.size()), ink, 0, width);
}

/// The position of the sun: straight above the middle for a light from above, lower at the sides.
ImVec2 sunAt(const PlotBox& box, float light) {
    const float em = ImGui::GetFontSize();
    const ImVec2 foot = box.at(0.5F, 0);
    const float across = box.width() / 2 - em;
    const float up = box.height() - em;
    constexpr float lowest = 0.62F; // it never covers the bump
    return {foot.x + std::sin(light) * across, foot.y - std::lerp(lowest, 1.0F, std::cos(light)) * up};
}

/// The heights, the moved heights, the position and the light. The position and the sun can be dragged.
void drawHeights(EmbossTheoryState& state, const EmbossFigure& figure, const PlotBox& box) {
    const float em = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 sun = sunAt(box, figure.light);
    ImGui::SetCursorScreenPos(sun - ImVec2(em, em));
    ImGui::InvisibleButton("sun", {2 * em, 2 * em});
    item("emboss:sun", "The distant light. Drag it.");
    const bool holdsSun = ImGui::IsItemActive();
    const bool overSun = holdsSun || ImGui::IsItemHovered();
    if (holdsSun) {
        const float across =
            (ImGui::GetIO().MousePos.x - box.atX(0.5F)) / std::max(1.0F, box.width() / 2 - em);
        state.angle =
            std::clamp(glm::degrees(std::asin(std::clamp(across, -1.0F, 1.0F))), -steepest, steepest);
    }
    ImGui::SetCursorScreenPos(box.low);
    ImGui::InvisibleButton("heights", {box.width(), box.height()});
    noteItem("emboss:heights");
    if (ImGui::IsItemActive())
        state.s = std::clamp(box.xOf(ImGui::GetIO().MousePos.x), 0.0F, 1.0F);
    helpTip("The height H across the surface, and dashed the height moved towards the light. Drag to read a "
            "place.");

    draw.AddRectFilled(box.low, box.high, color::ground);
    draw.PushClipRect(box.low, box.high, true);
    const ImDrawListFlags flags = draw.Flags; // antialiased edges would be visible seams
    draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (int i = 0; i + 1 < embossColumns; ++i) {
        const ImVec2 a = box.at(columnS(i), figure.profile.heightAt(columnS(i)));
        const ImVec2 b = box.at(columnS(i + 1), figure.profile.heightAt(columnS(i + 1)));
        draw.AddQuadFilled(a, b, {b.x, box.high.y}, {a.x, box.high.y}, color::lit);
    }
    draw.Flags = flags;
    for (int i = 0; i + 1 < embossColumns; i += 6) { // dashes
        std::array<ImVec2, 4> dash{};
        for (int k = 0; k < 4; ++k) {
            const float s = columnS(std::min(i + k, embossColumns - 1));
            dash.at(static_cast<std::size_t>(k)) = box.at(s, figure.at(s).h1);
        }
        draw.AddPolyline(dash.data(), 4, color::accent, 0, plotLine() * 1.5F);
    }
    drawEmbossCurve(draw, box, color::text, plotLine() * 1.5F,
                    [&](float s) { return figure.profile.heightAt(s); });
    const EmbossedPoint point = figure.at(state.s);
    const ImVec2 here = box.at(state.s, point.h0);
    const ImVec2 there = box.at(state.s + point.offset, point.h1);
    draw.AddLine({here.x, box.low.y}, {here.x, box.high.y}, color::probed, plotLine());
    // Towards the light, at the distance of the sun.
    sun = sunAt(box, figure.light);
    const ImVec2 way(std::sin(figure.light), -std::cos(figure.light));
    const ImVec2 tip = here + way * (em * 3.2F);
    const ImVec2 side = ImVec2(-way.y, way.x) * em * 0.2F;
    draw.AddLine(here, tip, color::chosen, plotLine() * 1.5F);
    draw.AddTriangleFilled(tip + way * em * 0.4F, tip + side, tip - side, color::chosen);
    const float dot = em * 0.24F;
    draw.AddCircleFilled(there, dot, color::accent);
    draw.AddCircleFilled(here, dot, color::probed);
    draw.AddCircleFilled(sun, em * (overSun ? 0.62F : 0.5F), color::chosen);
    for (int i = 0; i < 8; ++i) {
        const float turn = static_cast<float>(i) * glm::radians(45.0F);
        const ImVec2 ray(std::cos(turn), std::sin(turn));
        draw.AddLine(sun + ray * em * 0.65F, sun + ray * em * 0.95F, color::chosen, plotLine());
    }
    draw.PopClipRect();
    draw.AddRect(box.low, box.high, color::outline);
}

/// The grey values of the first pass as a curve.
void drawGrey(const EmbossTheoryState& state, const EmbossFigure& figure, const PlotBox& box) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(box.low, box.high, color::ground);
    for (const auto& [grey, anchor] : {std::pair(box.yFrom, 1.0F), std::pair(box.yTo, 0.0F)})
        plotText({box.high.x - plotLine() * 3, box.atY(grey)}, {1, anchor}, fmt::format("{:.2f}", grey),
                 color::dim);
    draw.AddLine(box.at(0, 0.5F), box.at(1, 0.5F), color::faint, plotLine());
    drawEmbossCurve(draw, box, color::changed, plotLine() * 1.5F, [&](float s) { return figure.at(s).grey; });
    draw.AddLine({box.atX(state.s), box.low.y}, {box.atX(state.s), box.high.y}, color::probed, plotLine());
    draw.AddCircleFilled(box.at(state.s, figure.at(state.s).grey), ImGui::GetFontSize() * 0.2F,
                         color::probed);
    draw.AddRect(box.low, box.high, color::outline);
}

/// The largest distance of the grey curve from 0.5, slightly enlarged.
float greyReach(const EmbossFigure& figure) {
    float most = 0;
    for (int i = 0; i < embossColumns; ++i)
        most = std::max(most, std::abs(figure.at(columnS(i)).grey - 0.5F));
    for (const float step : {0.05F, 0.1F, 0.25F}) {
        if (most <= step)
            return step;
    }
    return 0.5F;
}

/// The colours of the positions in a row.
template<class Color>
void drawEmbossStrip(const EmbossTheoryState& state, const PlotBox& box, const Color& colorOf) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (int i = 0; i < embossColumns; ++i) {
        const float from = static_cast<float>(i) / embossColumns;
        const float to = static_cast<float>(i + 1) / embossColumns;
        draw.AddRectFilled(box.at(from, 1), box.at(to, 0), plotColor(colorOf(columnS(i))));
    }
    const float x = box.atX(state.s);
    draw.AddLine({x, box.low.y}, {x, box.high.y}, color::shade, plotLine() * 3);
    draw.AddLine({x, box.low.y}, {x, box.high.y}, color::probed, plotLine());
    draw.AddRect(box.low, box.high, color::outline);
}

void drawEmbossDrawings(EmbossTheoryState& state, const EmbossFigure& figure, ImVec2 size) {
    const float em = ImGui::GetFontSize();
    constexpr std::array names{N_("Heights"), N_("Relief"), N_("Grey"), N_("Lit")};
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float left = origin.x + plotNamesWidth(names);
    const float right = origin.x + size.x;
    const float strip = em * 1.1F;
    const float gap = em * 0.25F;
    const float scale = em * 1.1F;
    const float curves = std::max(size.y - 2 * strip - 3 * gap - scale, em * 5);
    float y = origin.y;
    const auto next = [&](float height, float most) {
        const PlotBox box{{left, y}, {right, y + height}, 0, 1, 0, most};
        y += height + gap;
        return box;
    };
    const PlotBox heights = next(curves * 0.68F, 1.5F);
    PlotBox grey = next(curves * 0.32F, 1);
    const float reach = greyReach(figure);
    grey.yFrom = 0.5F - reach;
    grey.yTo = 0.5F + reach;
    const PlotBox greys = next(strip, 1);
    const PlotBox lit = next(strip, 1);
    drawHeights(state, figure, heights);
    drawGrey(state, figure, grey);
    drawEmbossStrip(state, greys, [&](float s) { return glm::vec3(figure.at(s).grey); });
    drawEmbossStrip(state, lit, [&](float s) { return figure.at(s).color; });
    plotNames(origin.x, names, std::array{heights, grey, greys, lit});
    plotText({left, lit.high.y + 1}, {0, 0}, "0", color::dim);
    plotText({(left + right) / 2, lit.high.y + 1}, {0.5F, 0}, "s", color::s);
    plotText({right, lit.high.y + 1}, {1, 0}, "1", color::dim);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy({size.x, y + scale - origin.y});
}

/// A line of the calculation.
void embossLine(const Sentence& words, ImU32 ink, std::string_view name) {
    wrappedText(words, ink);
    noteItem(name);
}

void numberLine(const char* name, ImU32 ink) {
    ImGui::AlignTextToFramePadding();
    plainText(name, ink);
    ImGui::SameLine(0, ImGui::GetFontSize() * 0.4F);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.8F);
}

/// The controls: the line, the light, the offset of the second map, the position.
void drawEmbossChoices(const Session& session, EmbossTheoryState& state, std::optional<ParamPlace>& depth) {
    const float em = ImGui::GetFontSize();
    const std::array lines{Segment{N_("Bump and block")}, Segment{N_("Bricks")}};
    if (const auto pressed =
            drawSegments(lines, std::min(em * 15, ImGui::GetContentRegionAvail().x),
                         static_cast<std::size_t>(state.line), [](std::size_t i) {
                             item(i == 0 ? "emboss:sketch" : "emboss:bricks",
                                  "The surface that the line crosses: a sketch or the program's bricks.");
                         }))
        state.line = static_cast<EmbossTheoryState::Line>(*pressed);
    numberLine("s", color::s);
    dragNumber("##place", state.s, placeRange, 0);
    noteItem("emboss:s");
    ImGui::SameLine(0, em * 0.7F);
    numberLine(tr("Light"), color::chosen);
    dragNumber("##light", state.angle, angleRange, -1);
    item("emboss:light", "The angle of the light from the normal, towards increasing s.");
    sameLineFor(em * 11, em * 0.7F);
    numberLine("MAX_EMBOSS", color::text);
    float shift = depth ? numberAt(*depth, 0) : state.depth;
    const Range range = depth ? rangeOf(*depth) : Range{0, 0.2F, 0.001F, {}};
    if (dragNumber("##depth", shift, range, -1)) {
        if (depth)
            assignNumber(session, *depth, 0, shift);
        else
            state.depth = shift;
    }
    noteItem("emboss:depth");
    sealAfterItem(session);
    helpTip(depth
                ? "The maximum shift of the second map: the scene's depth of embossing."
                : N_("The maximum shift of the second map. No unit of the scene embosses, so it affects the "
                     "figure only."));
}

void drawEmbossNumbers(const EmbossTheoryState& state, const EmbossFigure& figure) {
    const EmbossedPoint point = figure.at(state.s);
    const float em = ImGui::GetFontSize();
    embossLine(Sentence("ds = S·l × MAX_EMBOSS = {0:.2f} × {1:.3f} = {2:.4f}", std::sin(figure.light),
                        figure.depth, point.offset),
               color::text, fmt::format("emboss:ds {:.4f}", point.offset));
    embossLine(ProperName{fmt::format("H0 = H(s) = {:.2f}", point.h0)}, color::probed,
               fmt::format("emboss:h0 {:.2f}", point.h0));
    ImGui::SameLine(0, em);
    embossLine(Sentence("H1 = H(s + ds) = {0:.2f}", point.h1), color::accent,
               fmt::format("emboss:h1 {:.2f}", point.h1));
    embossLine(Sentence("grey = 0.5 + (H0 - H1) / 2 = {0:.2f}", point.grey), color::changed,
               fmt::format("emboss:grey {:.2f}", point.grey));
    embossLine(Sentence("(1 + H0 - H1) × light × texel = {0:.2f} × {1:.2f} × texel", 2 * point.grey,
                        figure.brightness),
               color::text, "emboss:color");
    ImGui::SameLine(0, em * 0.4F);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({em * 1.6F, em});
    const ImVec2 high = low + ImVec2(em * 1.6F, em);
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, plotColor(point.color));
    ImGui::GetWindowDrawList()->AddRect(low, high, color::outline);
    const char* seen = point.grey < 0.497F ? N_("The surface rises towards the light: H1 is larger, so it "
                                                "is darker.")
                       : point.grey > 0.503F
                           ? N_("The surface falls towards the light: H0 is larger, so it "
                                "is brighter.")
                           : N_("The surface is flat: the heights cancel, and 0.5 is left.");
    wrappedText(seen);
    dimWrappedText(
        N_("NeHe's text calls m = H1 - H0 the slope, but its formula, Fd + (H0 - H1), and its program "
           "have the other sign."));
}

} // namespace

void drawEmbossTheory(const Session& session, EmbossTheoryState& state) {
    const float em = ImGui::GetFontSize();
    fittedText(
        N_("Drag the sun, a place on the surface, and MAX_EMBOSS: slopes that face the light get bright."),
        color::dim);
    std::optional<ParamPlace> depth = embossDepth(session);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x > em * 44;
    const float right = beside ? std::max(em * 27, room.x * 0.38F) : room.x;
    const ImVec2 top = ImGui::GetCursorPos();
    const float light = glm::radians(state.angle);
    const EmbossFigure figure{profileOf(state), light, depth ? numberAt(*depth, 0) : state.depth,
                              brightnessOf(presentScene(session), light)};
    const ImVec2 size(beside ? room.x - right - em : room.x,
                      beside ? std::max(room.y - ImGui::GetStyle().ItemSpacing.y, em * 10) : em * 12);
    drawEmbossDrawings(state, figure, size);
    if (beside)
        ImGui::SetCursorPos({top.x + size.x + em, top.y});
    ImGui::BeginGroup();
    drawEmbossChoices(session, state, depth);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
    drawEmbossNumbers(state, figure);
    ImGui::PopStyleVar();
    ImGui::EndGroup();
}

} // namespace texplorer::ui
