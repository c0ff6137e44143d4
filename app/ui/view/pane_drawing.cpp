#include "app/ui/view/pane_drawing.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/kept.h"
#include "app/ui/view/renderer_choice.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

namespace {

/// The label, or its first word if there is no room.
std::string labelWithin(RendererKind renderer, float width) {
    const std::string words = tr(rowOf(renderer).label);
    return ImGui::CalcTextSize(words.c_str()).x <= width ? words : words.substr(0, words.find(' '));
}

float chipPad() {
    return ImGui::GetFontSize() * 0.3F;
}

float comboWidth(RendererKind renderer) {
    return buttonWidth(rowOf(renderer).label) + ImGui::GetFrameHeight();
}

/// A list of the renderers over the picture, as wide as its text, at most `width`.
void rendererCombo(const Session& session, std::size_t which, ImVec2 at, float width) {
    const RendererKind compared = session.view.compared[which];
    const std::string id = fmt::format("##compared{}", which);
    ImGui::SetCursorScreenPos(at);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, color::shade);
    ImGui::SetNextItemWidth(std::min(comboWidth(compared), width));
    const bool open = beginCombo(id.c_str(), labelWithin(compared, listRoom(width)).c_str());
    ImGui::PopStyleColor();
    const std::string name = fmt::format("compared:{}", which);
    noteItem(name);
    if (!open)
        return;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const ViewSettings& settings = session.view;
        const auto flags =
            settings.offered.has(renderer) ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(label(row.label).c_str(), renderer == compared, flags))
            act(session, [which, renderer](Session& changed) { changed.view.compared.at(which) = renderer; });
        item(fmt::format("{}={}", name, row.name), helpOf(settings, row));
    }
    endCombo();
}

/// "A" on the left of the view, "Now" on its right; or a note that the view shows only A.
void sideLabels(const Session& session, const Panes& panes) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float gap = ImGui::GetFontSize() * 0.8F;
    const Rect& frame = panes.all().front().frame;
    const float y = static_cast<float>(frame.y) + gap;
    const auto chip = [&](float x, const char* name, const char* text) {
        drawChip(draw, {x, y}, text, color::text, chipPad());
        const ImVec2 size = ImGui::CalcTextSize(text);
        noteDrawn(name, {x, y}, {x + size.x, y + size.y});
    };
    if (isKeptShown(session))
        chip(static_cast<float>(frame.x) + gap, "side:A", tr("Only A"));
    if (!isKeptBeside(session))
        return;
    const char* now = tr("Now");
    chip(static_cast<float>(frame.x) + gap, "side:A", "A");
    chip(static_cast<float>(frame.right()) - gap - ImGui::CalcTextSize(now).x, "side:Now", now);
}

} // namespace

void drawChip(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 tint, float pad) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    draw.AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + size.x + pad, at.y + size.y + pad / 2},
                       color::shade, pad);
    draw.AddText(at, tint, text.c_str());
}

view::PictureHandle pictureOf(const Pane& pane, const Pictures& pictures) {
    if (!pane.renderer)
        return pictures.difference ? pictures.difference->heatMap : view::PictureHandle::None;
    const auto view = std::ranges::find_if(pictures.frames, [&pane](const ViewFrame& frame) {
        return frame.renderer == *pane.renderer && frame.side == pane.side;
    });
    return view == pictures.frames.end() ? view::PictureHandle::None : view->frame.picture;
}

bool isDrawing(const Pictures& pictures, std::span<const RendererKind> renderers) {
    return std::ranges::any_of(pictures.frames, [&](const ViewFrame& view) {
        return !view.whole && std::ranges::find(renderers, view.renderer) != renderers.end();
    });
}

void drawPane(ImDrawList& draw, const Panes& panes, const Pane& pane, const Pictures& pictures,
              const ViewSettings& settings) {
    const ImVec2 low = lowOf(pane.frame);
    const ImVec2 high = highOf(pane.frame);
    draw.PushClipRect(lowOf(pane.visible), highOf(pane.visible));
    const view::PictureHandle picture = pictureOf(pane, pictures);
    const bool covered = picture != view::PictureHandle::None && pictures.setBlending;
    if (!covered)
        draw.AddRectFilled(low, high, color::ground);
    if (picture != view::PictureHandle::None) {
        if (pictures.setBlending)
            draw.AddCallback(pictures.setBlending, nullptr);
        panes.draw(draw, pane, picture);
        if (pictures.setBlending)
            draw.AddCallback(pictures.setBlending, &draw);
    } else if (pictures.setBlending) {
        const bool comes = pane.renderer ? isDrawing(pictures, {&*pane.renderer, 1})
                                         : isDrawing(pictures, settings.compared);
        const char* text = tr(comes ? "Drawing…" : N_("No picture: see the status bar"));
        const ImVec2 size = ImGui::CalcTextSize(text);
        draw.AddText({(low.x + high.x - size.x) / 2, (low.y + high.y - size.y) / 2}, color::dim, text);
    }
    draw.PopClipRect();
}

void paneLabels(const Session& session, const Panes& panes) {
    const ViewSettings& settings = session.view;
    sideLabels(session, panes);
    const float gap = ImGui::GetFontSize() * 0.4F;
    const float left = comboWidth(settings.compared[0]);
    const float right = comboWidth(settings.compared[1]);
    const auto lists = [&](const Rect& frame, bool apart) {
        const auto width = static_cast<float>(frame.width) - 2 * gap;
        const ImVec2 at(static_cast<float>(frame.x) + gap, static_cast<float>(frame.y) + gap);
        rendererCombo(session, 0, at, width);
        // In a narrow view the second one is below the first one.
        const float y = left + right + gap <= width ? at.y : at.y + ImGui::GetFrameHeight() + gap;
        const float x = apart ? at.x + std::max(0.0F, width - right) : y > at.y ? at.x : at.x + left + gap;
        rendererCombo(session, 1, {x, y}, width);
    };
    const std::vector<Pane>& all = panes.all();
    if (settings.arrangement == Arrangement::Split)
        return lists(all.front().frame, true);
    if (settings.arrangement != Arrangement::Grid)
        return;
    for (const Pane& pane : all) {
        if (pane.renderer)
            drawChip(*ImGui::GetWindowDrawList(),
                     {static_cast<float>(pane.frame.x) + 2 * gap, static_cast<float>(pane.frame.y) + gap},
                     labelWithin(*pane.renderer, static_cast<float>(pane.frame.width) - 4 * gap), color::text,
                     chipPad());
        else
            lists(pane.frame, false);
    }
}

void paneSeam(const Session& session, const Layout& layout) {
    const Arrangement arrangement = session.view.arrangement;
    if (arrangement != Arrangement::Split && arrangement != Arrangement::Kept)
        return;
    const Rect& whole = layout.picture;
    const float handle = ImGui::GetFontSize() * 0.4F;
    const float reach = std::max(handle, targetHeight() / 2);
    const float x =
        static_cast<float>(whole.x) + std::round(session.view.split * static_cast<float>(whole.width));
    // At the picture's edge, where the panel's padding gets no mouse, the grip stays inside.
    const float grip = std::clamp(
        x - reach, static_cast<float>(whole.x) + reach,
        std::max(static_cast<float>(whole.x) + reach, static_cast<float>(whole.right()) - 3 * reach));
    ImGui::SetCursorScreenPos({grip, static_cast<float>(whole.y)});
    ImGui::InvisibleButton("seam", {2 * reach, static_cast<float>(whole.height)});
    noteItem("picture seam");
    const bool held = ImGui::IsItemActive();
    if (held)
        act(session, [to = std::clamp((ImGui::GetIO().MousePos.x - static_cast<float>(whole.x)) /
                                          static_cast<float>(whole.width),
                                      0.0F, 1.0F)](Session& changed) { changed.view.split = to; });
    if (held || ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const ImU32 tint = held || ImGui::IsItemHovered() ? color::text : color::outline;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 top(x, lowOf(whole).y);
    const ImVec2 bottom(x, highOf(whole).y);
    draw.AddLine(top, bottom, color::shade, 3);
    draw.AddLine(top, bottom, tint, 1);
    const ImVec2 middle(x, (top.y + bottom.y) / 2);
    draw.AddRectFilled({middle.x - handle * 0.6F, middle.y - 3 * handle},
                       {middle.x + handle * 0.6F, middle.y + 3 * handle}, tint, handle * 0.6F);
}

void drawLegend(ImDrawList& draw, const Pane& pane, const HeatScale& scale) {
    const float em = ImGui::GetFontSize();
    const float width = std::min(static_cast<float>(pane.frame.width) - 2 * em, em * 22);
    if (width < em * 3)
        return;
    const char* words = tr("Difference, of 255");
    const bool hasWords = ImGui::CalcTextSize(words).x <= width;
    const ImVec2 low(static_cast<float>(pane.frame.x) + em,
                     static_cast<float>(pane.frame.bottom()) - em * 2.3F);
    const float bar = em * 0.6F;
    const float pad = em * 0.5F;
    const float above = hasWords ? em * 1.15F : 0;
    draw.AddRectFilled({low.x - pad, low.y - pad - above}, {low.x + width + pad, low.y + bar + em * 1.4F},
                       color::shade, pad);
    if (hasWords)
        draw.AddText({low.x, low.y - pad * 0.4F - above}, color::dim, words);
    // The positions of the numbers: equal steps.
    std::vector<int> marks{0, scale.tolerance};
    for (int next = scale.tolerance + 1; next < scale.top; next *= 4)
        marks.push_back(next);
    if (marks.size() > 3 && marks.back() * 2 > scale.top)
        marks.pop_back();
    marks.push_back(scale.top);
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
    const auto steps = static_cast<float>(marks.size() - 1);
    drawBar(draw, low, {width, bar}, [&](float share) {
        const float place = share * steps;
        const auto from = static_cast<std::size_t>(place);
        return heatColor(std::lerp(static_cast<float>(marks[from]), static_cast<float>(marks[from + 1]),
                                   place - static_cast<float>(from)),
                         scale);
    });
    std::vector<LegendMark> numbers;
    for (const int each : marks)
        numbers.push_back({width * static_cast<float>(numbers.size()) / steps, std::to_string(each),
                           each == scale.tolerance ? color::text : color::dim});
    drawMarks(draw, numbers, {low.x, low.y + bar + em * 0.15F}, width, em * 0.3F);
}

void drawBar(ImDrawList& draw, ImVec2 low, ImVec2 size,
             const std::function<std::array<std::uint8_t, 4>(float)>& colorAt) {
    constexpr int columns = 128;
    const auto at = [&](int column) { return low.x + size.x * static_cast<float>(column) / columns; };
    for (int i = 0; i < columns; ++i) {
        const auto [r, g, b, a] = colorAt((static_cast<float>(i) + 0.5F) / columns);
        draw.AddRectFilled({at(i), low.y}, {at(i + 1), low.y + size.y}, IM_COL32(r, g, b, a));
    }
}

void drawMarks(ImDrawList& draw, const std::vector<LegendMark>& marks, ImVec2 low, float width, float gap) {
    const auto widthOf = [](const LegendMark& mark) { return ImGui::CalcTextSize(mark.text.c_str()).x; };
    const float last = low.x + width - widthOf(marks.back());
    float free = low.x;
    for (const LegendMark& mark : marks) {
        const float own = widthOf(mark);
        const float x = std::clamp(low.x + mark.x - own / 2, low.x, low.x + width - own);
        if (&mark != &marks.back() && (x < free || x + own + gap > last))
            continue;
        draw.AddText({x, low.y}, mark.ink, mark.text.c_str());
        free = x + own + gap;
    }
}

void markPixel(ImDrawList& draw, const Panes& panes, glm::ivec2 pixel, ImU32 tint) {
    const float extent = std::max(panes.pixelExtent().x, panes.pixelExtent().y);
    const float radius = std::max(extent * 0.75F, ImGui::GetFontSize() * 0.45F);
    for (const Pane& pane : panes.all()) {
        const ImVec2 at = panes.toWindow(pane, glm::vec2(pixel) + 0.5F);
        draw.PushClipRect(lowOf(pane.visible), highOf(pane.visible));
        draw.AddCircle(at, radius, color::shade, 0, 4);
        draw.AddCircle(at, radius, tint, 0, 1.5F);
        draw.PopClipRect();
    }
}

} // namespace texplorer::ui
