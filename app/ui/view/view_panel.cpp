#include "app/ui/view/view_panel.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/lesson_key_edits.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/shown_passes.h"
#include "app/ui/state/camera.h"
#include "app/ui/state/chosen_vertices.h"
#include "app/ui/view/framing.h"
#include "app/ui/view/pane_drawing.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "texplorer/scene/picking.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr const char* cameraEdit = N_("Move camera"); // never sealed: moving the camera is one undo step

constexpr const char* frameLabel = N_("Frame");
constexpr const char* frameHelp = N_("Moves the camera so that all models are in view (F or double click)");
constexpr const char* moreLabel = "…";

/// The choices of the tool row that do not fit, and Frame.
void moreMenu(const Session& session, const Layout& layout, std::size_t first) {
    if (!beginPopup("more"))
        return;
    const auto shown = shownNow(presentScene(session));
    for (std::size_t i = first; i < showRows.size(); ++i) {
        const ShowRow& row = showRows[i];
        const bool chosen = shown == row.show;
        if (ImGui::MenuItem(label(row.label), nullptr, chosen) && !chosen)
            show(session, row, layout);
        noteItem(std::string("show:") + row.label);
    }
    ImGui::Separator();
    if (ImGui::MenuItem(label(frameLabel), "F"))
        frameAll(session, layout);
    item("frame", frameHelp);
    endPopup();
}

/// The choices of what the view shows. Those that do not fit are in a menu at the end.
void toolRow(const Session& session, const Layout& layout) {
    ImGui::SetCursorPos(
        {ImGui::GetStyle().WindowPadding.x,
         (static_cast<float>(layout.picture.y - layout.view.y) - ImGui::GetFrameHeight()) / 2});
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    const float left = ImGui::GetCursorPosX();
    const float right = ImGui::GetWindowContentRegionMax().x;
    const float choice = shownChoiceWidth(session.view) + gap;
    float all = buttonWidth(frameLabel) + choice;
    for (const ShowRow& row : showRows)
        all += buttonWidth(row.label) + gap;
    const bool fits = left + all <= right;
    const float end = fits ? right : right - buttonWidth(moreLabel) - gap - choice;
    std::size_t count = 0; // the number of choices that fit
    for (float x = left; count < showRows.size(); ++count) {
        x += buttonWidth(showRows[count].label);
        if (x > end)
            break;
        x += gap;
    }
    const auto shown = shownNow(presentScene(session));
    for (std::size_t i = 0; i < count; ++i) {
        const ShowRow& row = showRows[i];
        const bool chosen = shown == row.show;
        if (flatButton(label(row.label), chosen) && !chosen)
            show(session, row, layout);
        noteItem(std::string("show:") + row.label);
        ImGui::SameLine(0, gap);
    }
    const char* last = fits ? frameLabel : moreLabel;
    ImGui::SetCursorPosX(std::max(left, right - buttonWidth(last) - choice));
    drawShownChoice(session);
    ImGui::SameLine(0, gap);
    const bool pressed =
        button(last, fits ? "frame" : N_("more choices"), fits ? frameHelp : N_("More controls"));
    if (pressed && fits)
        frameAll(session, layout);
    else if (pressed)
        ImGui::OpenPopup("more");
    moreMenu(session, layout, count);
}

/// With Ctrl the mouse moves and enlarges the pictures like a magnifying glass; otherwise it moves the
/// camera.
void moveView(const Session& session, bool hovered, bool active, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 way(io.MouseDelta.x / static_cast<float>(session.view.zoom.factor),
                     io.MouseDelta.y / static_cast<float>(session.view.zoom.factor));
    const bool moved = active && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
    if (io.KeyCtrl) {
        if (moved)
            act(session,
                [layout, by = io.MouseDelta](Session& changed) { movePictures(changed.view, layout, by); });
        if (hovered && io.MouseWheel != 0)
            act(session, [layout, place = io.MousePos, notches = io.MouseWheel > 0 ? 1 : -1](
                             Session& changed) { zoomPictures(changed.view, layout, place, notches); });
        return;
    }
    View view = presentScene(session).view;
    if (moved) {
        const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
        const bool sideways = ImGui::IsMouseDragging(ImGuiMouseButton_Right) ||
                              ImGui::IsMouseDragging(ImGuiMouseButton_Middle) || (left && io.KeyShift);
        if (sideways)
            pan(view, way.x, way.y, static_cast<float>(layout.picture.height));
        else if (left)
            orbit(view, way.x, way.y);
    }
    if (hovered && io.MouseWheel != 0)
        zoom(view, io.MouseWheel);
    if (view != presentScene(session).view)
        submitDrag(session, cameraEdit, [&view](Scene& scene) { scene.view = view; });
}

/// Like projectVertex, but without making the mesh again.
std::optional<glm::vec2> placeOf(const Session& session, const PickedVertex& picked, float aspect) {
    const double time = session.look.playback.time;
    const Scene& scene = presentScene(session);
    if (!std::cmp_equal(picked.model, session.look.selection.model))
        return projectVertex(scene, picked.model, picked.vertex, time, aspect);
    return projectVertices(scene, scene.models[picked.model], selectedMesh(session), {&picked.vertex, 1},
                           time, aspect)
        .front();
}

void drawMarker(const Session& session, const Layout& layout, const Panes& panes, const Pane& pane) {
    const Model* model = selectedModel(session);
    if (!model || !model->visible || !session.look.selection.vertex)
        return;
    const std::size_t vertex = *session.look.selection.vertex;
    const auto place =
        placeOf(session, {static_cast<std::size_t>(session.look.selection.model), vertex}, aspectOf(layout));
    if (!place)
        return;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = panes.shareToWindow(pane, *place);
    noteDrawn("marker", at, at);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircle(at, em * 0.45F, color::shade, 0, em * 0.3F);
    draw.AddCircle(at, em * 0.45F, color::chosen, 0, em * 0.15F);
    draw.AddCircleFilled(at, em * 0.12F, color::chosen);

    const Mesh& mesh = selectedMesh(session);
    if (vertex >= mesh.vertices.size())
        return;
    const int unit = session.look.selection.unit;
    const std::optional<std::uint32_t> source = coordSource(*model, mesh, unit, vertex);
    const glm::vec4 coord = source ? effectiveTexCoord(*model, mesh, unit, *source) : glm::vec4(0, 0, 0, 1);
    const std::string text = fmt::format("{}   ({:.2f}, {:.2f})", vertex, coord.x, coord.y);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    // Next to the vertex, inside of the picture.
    ImVec2 chip(at.x + em * 0.9F, at.y - size.y - em * 0.5F);
    chip.x = std::min(chip.x, static_cast<float>(pane.visible.right()) - size.x - em * 0.5F);
    chip.y = std::max(chip.y, static_cast<float>(pane.visible.y) + em * 0.4F);
    drawChip(draw, chip, text, color::chosen, em * 0.3F);
}

/// The other selected vertices, without the one that has the marker.
void drawChosenDots(const Session& session, const Layout& layout, const Panes& panes, const Pane& pane) {
    const std::vector<std::size_t> chosen = chosenVertices(session.look.selection);
    const Model* model = selectedModel(session);
    constexpr std::size_t maxChosen = 500; // Dear ImGui counts the vertices of a panel with 16 bits
    if (!model || !model->visible || chosen.size() < 2 || chosen.size() > maxChosen)
        return;
    const float em = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const double time = session.look.playback.time;
    for (const auto& place : projectVertices(presentScene(session), *model, selectedMesh(session), chosen,
                                             time, aspectOf(layout))) {
        if (!place)
            continue;
        const ImVec2 at = panes.shareToWindow(pane, *place);
        draw.AddCircleFilled(at, em * 0.26F, color::shade, 12);
        draw.AddCircleFilled(at, em * 0.18F, color::chosen, 12);
    }
}

/// A ring around the vertex under the pointer, here or in the texture space.
void drawHoverRing(const Session& session, const Layout& layout, const Panes& panes, const Pane& pane) {
    const std::optional<PickedVertex>& hovered =
        session.look.hoveredInView ? session.look.hoveredInView : session.look.hoveredInPlane;
    const std::vector<Model>& models = presentScene(session).models;
    if (!hovered || hovered->model >= models.size() || !models[hovered->model].visible)
        return;
    const auto place = placeOf(session, *hovered, aspectOf(layout));
    if (!place)
        return;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = panes.shareToWindow(pane, *place);
    noteDrawn(N_("hovered vertex"), at, at);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircle(at, em * 0.5F, color::shade, 24, em * 0.3F);
    draw.AddCircle(at, em * 0.5F, color::chosen, 24, em * 0.13F);
}

/// The vertex under the mouse, if any.
std::optional<PickedVertex> vertexUnderMouse(const Session& session, const Layout& layout,
                                             const Panes& panes) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Pane* pane = panes.under(mouse);
    if (!pane)
        return std::nullopt;
    return pickVertex(presentScene(session), session.look.playback.time, aspectOf(layout),
                      panes.shareAt(*pane, mouse));
}

/// Selects it; with Shift it is added to the selection or removed from it.
void pick(const Session& session, const Layout& layout, const Panes& panes) {
    if (!panes.under(ImGui::GetIO().MousePos))
        return;
    act(session, [picked = vertexUnderMouse(session, layout, panes),
                  adds = ImGui::GetIO().KeyShift](Session& changed) {
        Selection& selection = changed.look.selection;
        if (adds && picked && std::cmp_equal(picked->model, selection.model))
            return toggleVertex(selection, picked->vertex);
        if (picked)
            selection.model = static_cast<int>(picked->model);
        if (picked || !adds)
            chooseVertices(selection, picked ? std::vector{picked->vertex} : std::vector<std::size_t>{});
    });
}

/// What the mouse or fingers do, the least obvious first; as many hints as fit.
struct ViewHint {
    const char* words;
    const char* key = ""; ///< that a lesson may use
};
constexpr std::array mouseHints{ViewHint{N_("Hold E: explain"), "E"},
                                ViewHint{N_("Drag: orbit")},
                                ViewHint{N_("Wheel: zoom")},
                                ViewHint{N_("Right drag: pan")},
                                ViewHint{N_("M: magnifier"), "M"},
                                ViewHint{N_("Click: select a vertex")},
                                ViewHint{N_("Ctrl + wheel: enlarge the pixels")}};
constexpr std::array fingerHints{ViewHint{N_("Hold: explain")}, ViewHint{N_("Drag: orbit")},
                                 ViewHint{N_("Two fingers: zoom and pan")},
                                 ViewHint{N_("Tap: select a vertex")}};

std::span<const ViewHint> hintsOf(const Session& session) {
    if (areHintsForFingers(session))
        return fingerHints;
    return mouseHints;
}

Sentence hintsFor(const Session& session, float available) {
    Sentence line;
    for (const ViewHint& hint : hintsOf(session)) {
        if (isTakenByLesson(session, hint.key))
            continue;
        const Sentence longer = line.empty() ? hint.words : Sentence("{0}  ·  {1}", line, hint.words);
        if (ImGui::CalcTextSize(tr(longer).c_str()).x > available)
            break;
        line = longer;
    }
    return line;
}

/// Shows the hints, or a note that the picture and its values are of a preview.
void hintLine(const Session& session, const Layout& layout) {
    const float em = ImGui::GetFontSize();
    const float available = static_cast<float>(layout.view.width) - em;
    const Preview* const shown = shownPreview(session);
    const std::string line =
        shown ? fitted(Sentence("Preview: {0}", shown->text), available) : tr(hintsFor(session, available));
    const int top = std::max(layout.canvas.bottom(), layout.strip.bottom());
    const auto height = static_cast<float>(layout.view.bottom() - top);
    ImGui::SetCursorPos({(static_cast<float>(layout.view.width) - ImGui::CalcTextSize(line.c_str()).x) / 2,
                         static_cast<float>(top - layout.view.y) + (height - em) / 2});
    plainText(line, shown ? color::changed : color::dim);
    if (shown)
        noteItem("preview");
    else
        noteItem("view hints:" + line);
}

/// Shows over the lower edge that the picture is incomplete.
void stepLine(const Session& session, const Layout& layout) {
    const std::size_t count = shownScene(session).passes.size();
    const std::size_t shown = shownPasses(session);
    if (shown == count)
        return;
    const std::string line = tr(shown == 1 ? Sentence("Pass 0 of {0}", count)
                                           : Sentence("Passes 0 to {0} of {1}", shown - 1, count));
    const float em = ImGui::GetFontSize();
    const ImVec2 size = ImGui::CalcTextSize(line.c_str());
    const ImVec2 low(static_cast<float>(layout.picture.x) + em * 0.6F,
                     static_cast<float>(layout.picture.bottom()) - size.y - em * 0.8F);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({low.x - em * 0.4F, low.y - em * 0.2F},
                       {low.x + size.x + em * 0.4F, low.y + size.y + em * 0.2F}, color::shade, em * 0.25F);
    draw.AddText(low, color::changed, line.c_str());
}

void hoverPixel(const Session& session, std::optional<glm::ivec2> pixel) {
    const auto to = pixel ? std::optional(reference::PixelPlace{pixel->x, pixel->y}) : std::nullopt;
    if (session.look.levels.hovered != to)
        act(session, [to](Session& changed) { changed.look.levels.hovered = to; });
}

void hoverVertex(const Session& session, std::optional<PickedVertex> vertex) {
    if (session.look.hoveredInView != vertex)
        act(session, [vertex](Session& changed) { changed.look.hoveredInView = vertex; });
}

} // namespace

bool areHintsForFingers(const Session& session) {
    return session.settings.largeControls && !session.window.page.empty();
}

void drawViewPanel(const Session& session, const Pictures& pictures, const Layout& layout) {
    beginPanel(N_("View"), layout.view, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    toolRow(session, layout);

    const Panes panes(layout, session.view, pictures.frames.front().frame.size);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const Pane& pane : panes.all()) {
        drawPane(draw, panes, pane, pictures, session.view);
        drawFalseColors(draw, session, pictures, panes, pane);
    }
    if (pictures.difference && isRinged(pictures.difference->numbers))
        markPixel(draw, panes, pictures.difference->numbers.worst, color::problem);
    if (pictures.difference && !panes.all().back().renderer)
        drawLegend(draw, panes.all().back(), pictures.difference->scale);
    drawFalseColorLegend(draw, session, panes.all().front());
    paneLabels(session, panes); // before the button below, so that they get the mouse first
    paneSeam(session, layout);

    ImGui::SetCursorScreenPos(lowOf(layout.canvas));
    ImGui::InvisibleButton(
        "picture",
        {static_cast<float>(std::max(1, layout.canvas.width)), static_cast<float>(layout.canvas.height)},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
            ImGuiButtonFlags_MouseButtonMiddle);
    noteItem("view");
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    moveView(session, hovered, active, layout);
    bool clicked = false;
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        frameAll(session, layout);
    } else if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
               ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <
                   ImGui::GetIO().MouseDragThreshold * ImGui::GetIO().MouseDragThreshold) {
        pick(session, layout, panes);
        clicked = true;
    }
    const auto pixel = hovered ? panes.pixelAt(ImGui::GetIO().MousePos) : std::nullopt;
    hoverPixel(session, pixel);
    probeWithMouse(session, panes, hovered, clicked);
    if (!hovered || active)
        hoverVertex(session, std::nullopt);
    else if (const ImGuiIO& io = ImGui::GetIO();
             io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0)
        hoverVertex(session, vertexUnderMouse(session, layout, panes));
    for (const Pane& pane : panes.all()) {
        draw.PushClipRect(lowOf(pane.visible), highOf(pane.visible));
        drawProbedPixel(session, pictures, panes, pane);
        drawChosenDots(session, layout, panes, pane);
        drawMarker(session, layout, panes, pane);
        drawHoverRing(session, layout, panes, pane);
        draw.PopClipRect();
    }
    if (hovered)
        drawMagnifier(session, panes, pictures, layout);
    if (pixel)
        drawFalseColorTip(session, layout, *pixel);
    drawComparisonStrip(session, pictures, layout);
    stepLine(session, layout);
    hintLine(session, layout);
    ImGui::End();
}

} // namespace texplorer::ui
