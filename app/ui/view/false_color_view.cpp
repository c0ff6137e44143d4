#include "app/ui/language/translate.h"
#include "app/ui/model/level_view.h"
#include "app/ui/view/pane_drawing.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace texplorer::ui {
namespace {

using reference::Shown;

/// "λ ▾"
std::string shownLabel(const ViewSettings& settings) {
    return fmt::format("{} ▾", tr(texplorer::rowOf(settings.shown).label));
}

/// The meaning of a legend's colours.
struct FalseColorScale {
    Sentence title;
    Sentence shortTitle; ///< used if there is less room
    std::function<std::array<std::uint8_t, 4>(float place)> colorAt;
    std::vector<LegendMark> marks{};                        ///< at 0 to 1
    std::optional<std::array<std::uint8_t, 4>> magnified{}; ///< the field in front of it
};

FalseColorScale scaleOf(const reference::LevelMap& map, Shown shown, int unit) {
    if (shown == Shown::Lambda) {
        const int steps = reference::stepsOf(map); // levels above the base
        FalseColorScale scale{Sentence("λ of unit {0}, black where magnified", unit),
                              Sentence("λ of unit {0}", unit), [steps](float place) {
                                  return reference::lambdaColor(
                                      std::max(place, 1e-6F) * static_cast<float>(steps), steps);
                              }};
        for (int i = 0; i <= steps; ++i)
            scale.marks.push_back({static_cast<float>(i) / static_cast<float>(steps), std::to_string(i)});
        scale.magnified = reference::lambdaColor(0, steps);
        return scale;
    }
    FalseColorScale scale{Sentence("Footprint of unit {0}: longer side by shorter", unit),
                          Sentence("Footprint of unit {0}", unit), [](float place) {
                              return reference::ratioColor(std::pow(reference::maxShownRatio, place));
                          }};
    for (float ratio = 1; ratio <= reference::maxShownRatio; ratio *= 2)
        scale.marks.push_back({std::log2(ratio) / std::log2(reference::maxShownRatio),
                               ratio < reference::maxShownRatio ? fmt::format("{:.0f}", ratio)
                                                                : fmt::format("{:.0f}+", ratio)});
    return scale;
}

} // namespace

float shownChoiceWidth(const ViewSettings& settings) {
    return ImGui::CalcTextSize(shownLabel(settings).c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void shownItems(const Session& session) {
    const ViewSettings& settings = session.view;
    for (const EnumRow& row : EnumTable<Shown>::rows) {
        const auto shown = static_cast<Shown>(row.value);
        if (ImGui::MenuItem(label(row.label).c_str(), nullptr, settings.shown == shown))
            act(session, [shown](Session& changed) { changed.view.shown = shown; });
        item(fmt::format("shown:{}", row.name), row.help);
    }
    ImGui::Separator();
    const bool isIdle = settings.shown == Shown::Picture;
    ImGui::BeginDisabled(isIdle);
    float percent = std::round(settings.opacity * 100);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
    if (ImGui::SliderFloat("##opacity", &percent, 10, 100, "%.0f %%", ImGuiSliderFlags_AlwaysClamp))
        act(session, [percent](Session& changed) { changed.view.opacity = percent / 100; });
    ImGui::EndDisabled();
    item("false color opacity", isIdle ? N_("The opacity of the false colours. None are shown at present")
                                       : N_("The opacity of the false colours over the picture"));
    ImGui::SameLine();
    ImGui::TextUnformatted(tr("Opacity"));
}

void drawShownChoice(const Session& session) {
    const ViewSettings& settings = session.view;
    const bool isOn = settings.shown != Shown::Picture;
    const bool pressed = markedButton(fmt::format("{}###shown", shownLabel(settings)).c_str(), isOn);
    item("shown", "Shows the picture, or false colours for the level of detail (λ) or the elongation of each "
                  "pixel's footprint (anisotropy)");
    if (pressed)
        ImGui::OpenPopup(N_("shown choices"));
    if (beginPopup(N_("shown choices"))) {
        shownItems(session);
        endPopup();
    }
}

void drawFalseColors(ImDrawList& draw, const Session& session, const Pictures& pictures, const Panes& panes,
                     const Pane& pane) {
    const auto& answer = session.look.levels.answer;
    if (session.view.shown == Shown::Picture || !levelMapOf(session) || !answer->colors || !pane.renderer ||
        pane.side != view::Side::Now)
        return;
    const view::PictureHandle colors = pictures.showTexels(answer->colors);
    if (colors == view::PictureHandle::None)
        return;
    draw.PushClipRect(lowOf(pane.visible), highOf(pane.visible));
    panes.draw(draw, pane, colors, ImGui::ColorConvertFloat4ToU32({1, 1, 1, session.view.opacity}));
    draw.PopClipRect();
}

void drawFalseColorLegend(ImDrawList& draw, const Session& session, const Pane& pane) {
    const Shown shown = session.view.shown;
    if (shown == Shown::Picture)
        return;
    const float em = ImGui::GetFontSize();
    const float line = ImGui::GetTextLineHeight();
    const float pad = em * 0.5F;
    const float width = std::min(static_cast<float>(pane.frame.width) - 3 * em, em * 20);
    if (width < em * 4)
        return;
    const reference::LevelMap* map = levelMapOf(session);
    const auto& answer = session.look.levels.answer;
    // On the right, because the number of the passes is on the left.
    const float right = static_cast<float>(pane.frame.right()) - em;
    const ImVec2 low(right - width, static_cast<float>(pane.frame.bottom()) - 2.6F * line - 2 * pad);
    if (!map) {
        const Sentence words = answer && !answer->map
                                   ? Sentence("No false colours: {0}", answer->map.error().message)
                                   : N_("Computing the levels of the pixels…");
        const std::string text = fitted(words, width);
        const float y = static_cast<float>(pane.frame.bottom()) - line - 2 * pad;
        const float x = right - ImGui::CalcTextSize(text.c_str()).x;
        drawChip(draw, {x, y}, text, color::text, pad);
        noteDrawn("false colors:none", {x, y}, {right, y + line});
        return;
    }
    FalseColorScale scale = scaleOf(*map, shown, session.look.selection.unit);
    const float bar = em * 0.6F;
    const ImVec2 corner(low.x + width + pad, low.y + line + bar + pad + line);
    draw.AddRectFilled({low.x - pad, low.y - pad / 2}, corner, color::shade, pad);
    const bool hasRoom = textWidth(scale.title) <= width;
    const std::string title = fitted(hasRoom ? scale.title : scale.shortTitle, width);
    draw.AddText({low.x, low.y}, color::text, title.c_str());
    const float y = low.y + line + pad * 0.4F;
    float left = low.x;
    if (scale.magnified) {
        const float field = ImGui::CalcTextSize("≤ 0").x;
        const auto [r, g, b, a] = *scale.magnified;
        draw.AddRectFilled({left, y}, {left + field, y + bar}, IM_COL32(r, g, b, a));
        draw.AddRect({left, y}, {left + field, y + bar}, color::outline);
        draw.AddText({left, y + bar + pad * 0.2F}, color::text, "≤ 0");
        left += field + em;
    }
    const float length = low.x + width - left;
    drawBar(draw, {left, y}, {length, bar}, scale.colorAt);
    for (LegendMark& mark : scale.marks)
        mark.x *= length;
    drawMarks(draw, scale.marks, {left, y + bar + pad * 0.2F}, length, em * 0.35F);
    noteDrawn("false colors:legend", {low.x - pad, low.y - pad / 2}, corner);
}

void drawFalseColorTip(const Session& session, const Layout& layout, glm::ivec2 pixel) {
    const reference::LevelMap* map = levelMapOf(session);
    if (session.view.shown == Shown::Picture || session.view.magnifies || !map)
        return;
    const reference::PixelLevels* levels = map->at(pixel.x, pixel.y);
    if (!levels)
        return;
    const std::string text = tr(session.view.shown == Shown::Lambda ? reference::levelsText(*map, *levels)
                                                                    : reference::footprintText(*levels));
    const float em = ImGui::GetFontSize();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = em * 0.35F;
    ImVec2 at(mouse.x + em, mouse.y + em * 1.2F);
    at.x = std::max(pad, std::min(at.x, static_cast<float>(layout.window.right()) - size.x - 2 * pad));
    if (at.y + size.y + pad > static_cast<float>(layout.view.bottom()))
        at.y = mouse.y - size.y - em;
    drawChip(*ImGui::GetForegroundDrawList(), at, text, color::text, pad);
    noteDrawn("false colors:tip", at, {at.x + size.x, at.y + size.y});
}

} // namespace texplorer::ui
